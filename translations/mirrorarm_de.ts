<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
<context>
    <name>Alarm</name>
    <message>
        <source>Stopped: %1</source>
        <translation>Halt: %1</translation>
    </message>
    <message>
        <source>The cameras deliver no images</source>
        <translation>Die Kameras liefern keine Bilder</translation>
    </message>
    <message>
        <source>The robot does not answer</source>
        <translation>Der Roboter antwortet nicht</translation>
    </message>
    <message>
        <source>The force at the sling is high</source>
        <translation>Die Kraft an der Schlinge ist hoch</translation>
    </message>
    <message>
        <source>The force at the sling is near its limit</source>
        <translation>Die Kraft an der Schlinge ist nahe ihrer Grenze</translation>
    </message>
    <message>
        <source>The arm target is out of view; the robot holds</source>
        <translation>Das Armziel ist außer Sicht; der Roboter hält inne</translation>
    </message>
    <message>
        <source>The robot cannot follow: %1</source>
        <translation>Der Roboter kann nicht folgen: %1</translation>
    </message>
    <message>
        <source>The robot stays behind, to keep the arm target in view</source>
        <translation>Der Roboter bleibt zurück, damit das Armziel im Blick bleibt</translation>
    </message>
    <message>
        <source>The record cannot be written</source>
        <translation>Die Aufzeichnung kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>Some samples are missing in the record</source>
        <translation>In der Aufzeichnung fehlen einzelne Messwerte</translation>
    </message>
    <message>
        <source>Low</source>
        <translation>Niedrig</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>High</source>
        <translation>Hoch</translation>
    </message>
</context>
<context>
    <name>AlarmBar</name>
    <message>
        <source>Acknowledge</source>
        <translation>Bestätigen</translation>
    </message>
    <message>
        <source>No alarms</source>
        <translation>Keine Alarme</translation>
    </message>
    <message>
        <source> (is over)</source>
        <translation> (vorüber)</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 weitere</translation>
    </message>
    <message>
        <source>Alarm, %1: %2</source>
        <translation>Alarm, %1: %2</translation>
    </message>
</context>
<context>
    <name>BoardForm</name>
    <message>
        <source>Board</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>Points in a row</source>
        <translation>Punkte je Reihe</translation>
    </message>
    <message>
        <source>Rows of points</source>
        <translation>Punktreihen</translation>
    </message>
    <message>
        <source>Step from point to point in millimetres</source>
        <translation>Abstand von Punkt zu Punkt in Millimetern</translation>
    </message>
    <message>
        <source>Lens model</source>
        <translation>Linsenmodell</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Board</source>
        <translation>&amp;Platte</translation>
    </message>
    <message>
        <source>&amp;In a row</source>
        <translation>&amp;Je Reihe</translation>
    </message>
    <message>
        <source>&amp;Rows</source>
        <translation>&amp;Reihen</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>A&amp;bstand</translation>
    </message>
    <message>
        <source>&amp;Lens</source>
        <translation>&amp;Linse</translation>
    </message>
</context>
<context>
    <name>BoardImageView</name>
    <message>
        <source>Camera images</source>
        <translation>Kamerabilder</translation>
    </message>
    <message>
        <source>Tinted: points have been there. Dashed: where the board is wanted next</source>
        <translation>Getönt: dort lagen schon Punkte. Gestrichelt: dort wird die Platte als Nächstes gebraucht</translation>
    </message>
    <message>
        <source>The left camera sees %1 points of the board, the right one %2</source>
        <translation>Die linke Kamera sieht %1 Punkte der Platte, die rechte %2</translation>
    </message>
    <message>
        <source>No images yet</source>
        <translation>Noch keine Bilder</translation>
    </message>
    <message>
        <source>Left camera</source>
        <translation>Linke Kamera</translation>
    </message>
    <message>
        <source>Right camera</source>
        <translation>Rechte Kamera</translation>
    </message>
</context>
<context>
    <name>CalibrationGuide</name>
    <message>
        <source>Have the board ready: on the table for the robot to look at, or in your hand.</source>
        <translation>Halten Sie die Platte bereit: auf dem Tisch, wo der Roboter sie ansehen kann, oder in der Hand.</translation>
    </message>
    <message>
        <source>Lay the board before the cameras. It must not move until the end.</source>
        <translation>Legen Sie die Platte vor die Kameras. Sie darf sich bis zum Ende nicht bewegen.</translation>
    </message>
    <message>
        <source>Lay the board before the cameras. The robot turns them to and fro for some seconds.</source>
        <translation>Legen Sie die Platte vor die Kameras. Der Roboter schwenkt diese einige Sekunden hin und her.</translation>
    </message>
    <message>
        <source>Lay the board before the cameras. One view is enough, a grid of the robot tells more.</source>
        <translation>Legen Sie die Platte vor die Kameras. Eine Ansicht genügt; ein Raster des Roboters sagt mehr.</translation>
    </message>
    <message>
        <source>Make sure that nothing is in the robot&apos;s way, then reset the stop; nothing moves by that.</source>
        <translation>Vergewissern Sie sich, dass dem Roboter nichts im Weg ist. Setzen Sie dann den Halt zurück; dadurch bewegt sich nichts.</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Another board</source>
        <translation>Andere Platte</translation>
    </message>
    <message>
        <source>The pattern goes on beyond %1 × %2 points. Discard all and choose the board&apos;s true size.</source>
        <translation>Das Muster geht über %1 × %2 Punkte hinaus. Verwerfen Sie alles und wählen Sie die wahre Größe der Platte.</translation>
    </message>
    <message>
        <source>Show the board</source>
        <translation>Platte zeigen</translation>
    </message>
    <message>
        <source>Both cameras must see it, whole and evenly lit.</source>
        <translation>Beide Kameras müssen sie sehen, ganz und gleichmäßig beleuchtet.</translation>
    </message>
    <message>
        <source>This view was taken. Tilt the board, or bring it where no points have been yet.</source>
        <translation>Diese Ansicht ist aufgenommen. Neigen Sie die Platte oder bringen Sie sie dorthin, wo noch keine Punkte lagen.</translation>
    </message>
    <message>
        <source>This view was taken. Turn the cameras about another axis.</source>
        <translation>Diese Ansicht ist aufgenommen. Drehen Sie die Kameras um eine andere Achse.</translation>
    </message>
    <message>
        <source>Hold still</source>
        <translation>Ruhig halten</translation>
    </message>
    <message>
        <source>The view is taken.</source>
        <translation>Die Ansicht wird aufgenommen.</translation>
    </message>
    <message>
        <source>Ready to capture</source>
        <translation>Bereit zur Aufnahme</translation>
    </message>
    <message>
        <source>The board is still and the view is new.</source>
        <translation>Die Platte ist in Ruhe und die Ansicht ist neu.</translation>
    </message>
    <message>
        <source>Show more of the board</source>
        <translation>Mehr von der Platte zeigen</translation>
    </message>
    <message>
        <source>Most of its points must be seen by both cameras: uncover it, or bring it into the middle.</source>
        <translation>Die meisten Punkte müssen von beiden Kameras gesehen werden: Decken Sie sie auf oder bringen Sie sie in die Mitte.</translation>
    </message>
    <message>
        <source>The view is taken as soon as nothing moves.</source>
        <translation>Die Ansicht wird aufgenommen, sobald sich nichts mehr bewegt.</translation>
    </message>
    <message>
        <source>Show it in another way</source>
        <translation>Anders zeigen</translation>
    </message>
    <message>
        <source>The robot turns the cameras</source>
        <translation>Der Roboter schwenkt die Kameras</translation>
    </message>
    <message>
        <source>The robot drives to the next view</source>
        <translation>Der Roboter fährt zur nächsten Ansicht</translation>
    </message>
    <message>
        <source>Keep a hand near STOP. What is seen is taken by itself.</source>
        <translation>Halten Sie eine Hand nahe STOP. Was gesehen wird, wird selbsttätig aufgenommen.</translation>
    </message>
    <message>
        <source>Let the robot drive</source>
        <translation>Den Roboter fahren lassen</translation>
    </message>
    <message>
        <source>Both clocks are compared by one movement that the robot makes and the cameras see.</source>
        <translation>Beide Uhren werden an einer Bewegung verglichen, die der Roboter ausführt und die Kameras sehen.</translation>
    </message>
    <message>
        <source>Ready to solve</source>
        <translation>Bereit zum Berechnen</translation>
    </message>
    <message>
        <source>Solve now, or go on: more views make the result surer.</source>
        <translation>Berechnen Sie jetzt oder fahren Sie fort: Mehr Ansichten machen das Ergebnis sicherer.</translation>
    </message>
    <message>
        <source>Waiting for images</source>
        <translation>Warten auf Bilder</translation>
    </message>
    <message>
        <source>The cameras have not delivered an image yet.</source>
        <translation>Die Kameras haben noch kein Bild geliefert.</translation>
    </message>
    <message>
        <source>Look at the result</source>
        <translation>Ergebnis ansehen</translation>
    </message>
    <message>
        <source>Accepting writes the record and puts it in force. Until then nothing has changed.</source>
        <translation>Mit dem Annehmen wird das Protokoll geschrieben und in Kraft gesetzt. Bis dahin hat sich nichts geändert.</translation>
    </message>
    <message>
        <source>Solving</source>
        <translation>Berechnung</translation>
    </message>
    <message>
        <source>All views are brought into agreement. This takes some seconds.</source>
        <translation>Alle Ansichten werden in Einklang gebracht. Das dauert einige Sekunden.</translation>
    </message>
    <message>
        <source>No result</source>
        <translation>Kein Ergebnis</translation>
    </message>
    <message>
        <source>In force</source>
        <translation>In Kraft</translation>
    </message>
    <message>
        <source>Record %1 is written. Next: %2.</source>
        <translation>Das Protokoll %1 ist geschrieben. Als Nächstes: %2.</translation>
    </message>
</context>
<context>
    <name>CalibrationPresenter</name>
    <message>
        <source>Choose</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Capture</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Berechnen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
</context>
<context>
    <name>CalibrationResult</name>
    <message>
        <source>Every figure is within its limit.</source>
        <translation>Jeder Wert liegt innerhalb seiner Grenze.</translation>
    </message>
    <message>
        <source>Usable, but a figure is beyond its limit: more views would make it better.</source>
        <translation>Brauchbar, doch ein Wert liegt jenseits seiner Grenze: Mehr Ansichten würden es verbessern.</translation>
    </message>
    <message>
        <source>Not good enough: go back, remove the views that stand out and add others.</source>
        <translation>Nicht gut genug: Gehen Sie zurück, entfernen Sie die auffälligen Ansichten und nehmen Sie andere auf.</translation>
    </message>
</context>
<context>
    <name>CalibrationWindow</name>
    <message>
        <source>mirrorarm – calibration, simulation</source>
        <translation>mirrorarm – Kalibrierung, Simulation</translation>
    </message>
    <message>
        <source>mirrorarm – calibration</source>
        <translation>mirrorarm – Kalibrierung</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>To the session</source>
        <translation>Zur Sitzung</translation>
    </message>
    <message>
        <source>Light or dark</source>
        <translation>Hell oder dunkel</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
</context>
<context>
    <name>CalibrationWords</name>
    <message>
        <source>Stereo cameras</source>
        <translation>Stereokameras</translation>
    </message>
    <message>
        <source>Hand-eye</source>
        <translation>Hand-Auge</translation>
    </message>
    <message>
        <source>Clock offset</source>
        <translation>Uhrenversatz</translation>
    </message>
    <message>
        <source>Drift check</source>
        <translation>Driftprüfung</translation>
    </message>
    <message>
        <source>Finds the numbers of both lenses and how the cameras stand to each other.</source>
        <translation>Bestimmt die Kenngrößen beider Linsen und die Lage der Kameras zueinander.</translation>
    </message>
    <message>
        <source>Finds where the cameras sit on the robot&apos;s flange.</source>
        <translation>Bestimmt, wo die Kameras am Flansch des Roboters sitzen.</translation>
    </message>
    <message>
        <source>Finds how far the cameras&apos; clock is off the robot&apos;s.</source>
        <translation>Bestimmt, wie weit die Uhr der Kameras von der des Roboters abweicht.</translation>
    </message>
    <message>
        <source>Tells whether what is in force still holds.</source>
        <translation>Sagt, ob das, was in Kraft ist, noch gilt.</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Capture now</source>
        <translation>Jetzt aufnehmen</translation>
    </message>
    <message>
        <source>Capture by itself</source>
        <translation>Selbsttätig aufnehmen</translation>
    </message>
    <message>
        <source>Robot drives</source>
        <translation>Roboter fährt</translation>
    </message>
    <message>
        <source>Remove view</source>
        <translation>Ansicht entfernen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>Berechnen</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Annehmen</translation>
    </message>
    <message>
        <source>Back to the views</source>
        <translation>Zurück zu den Ansichten</translation>
    </message>
    <message>
        <source>Discard all</source>
        <translation>Alles verwerfen</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>Angenommen</translation>
    </message>
    <message>
        <source>Not possible in this step</source>
        <translation>In diesem Schritt nicht möglich</translation>
    </message>
    <message>
        <source>Both cameras must see the board. Show it to them and capture again</source>
        <translation>Beide Kameras müssen die Platte sehen. Zeigen Sie sie ihnen und nehmen Sie erneut auf</translation>
    </message>
    <message>
        <source>The board moves. Hold it still and capture again</source>
        <translation>Die Platte bewegt sich. Halten Sie sie ruhig und nehmen Sie erneut auf</translation>
    </message>
    <message>
        <source>The robot does not answer or is not at rest. Look at its controller</source>
        <translation>Der Roboter antwortet nicht oder ist nicht in Ruhe. Sehen Sie nach seiner Steuerung</translation>
    </message>
    <message>
        <source>Hold the enabling key, then let the robot drive</source>
        <translation>Halten Sie den Zustimmtaster, lassen Sie dann den Roboter fahren</translation>
    </message>
    <message>
        <source>Reset the stop first</source>
        <translation>Setzen Sie zuerst den Halt zurück</translation>
    </message>
    <message>
        <source>A calibration that this one stands on is missing. Do it first: stereo cameras, then hand-eye, then the others</source>
        <translation>Eine Kalibrierung, auf der diese beruht, fehlt. Führen Sie sie zuerst durch: Stereokameras, dann Hand-Auge, dann die übrigen</translation>
    </message>
    <message>
        <source>The record could not be written, and what was in force still is. Make room in the folder of the calibrations and accept again</source>
        <translation>Das Protokoll konnte nicht geschrieben werden; was in Kraft war, ist es weiterhin. Schaffen Sie Platz im Ordner der Kalibrierungen und nehmen Sie erneut an</translation>
    </message>
    <message>
        <source>The station is busy. Ask again</source>
        <translation>Die Station ist beschäftigt. Versuchen Sie es erneut</translation>
    </message>
    <message>
        <source>Chessboard</source>
        <translation>Schachbrett</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>Kreise</translation>
    </message>
    <message>
        <source>Asymmetric circles</source>
        <translation>Versetzte Kreise</translation>
    </message>
    <message>
        <source>Dot plate</source>
        <translation>Punktplatte</translation>
    </message>
    <message>
        <source>The calibrations hold</source>
        <translation>Die Kalibrierungen gelten</translation>
    </message>
    <message>
        <source>Doubtful: calibrate soon</source>
        <translation>Zweifelhaft: bald kalibrieren</translation>
    </message>
    <message>
        <source>Failed: calibrate before a session</source>
        <translation>Nicht bestanden: vor einer Sitzung kalibrieren</translation>
    </message>
</context>
<context>
    <name>CaptureLights</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Enough views</source>
        <translation>Genug Ansichten</translation>
    </message>
    <message>
        <source>Spread over both images</source>
        <translation>Über beide Bilder verteilt</translation>
    </message>
    <message>
        <source>Tilts</source>
        <translation>Neigungen</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>Enough movement</source>
        <translation>Genug Bewegung</translation>
    </message>
    <message>
        <source>Held still</source>
        <translation>Ruhig gehalten</translation>
    </message>
    <message>
        <source>A new view</source>
        <translation>Eine neue Ansicht</translation>
    </message>
    <message>
        <source>Seen by the left camera</source>
        <translation>Linke Kamera sieht sie</translation>
    </message>
    <message>
        <source>Seen by the right camera</source>
        <translation>Rechte Kamera sieht sie</translation>
    </message>
</context>
<context>
    <name>CapturePage</name>
    <message>
        <source>Views taken</source>
        <translation>Aufgenommene Ansichten</translation>
    </message>
    <message>
        <source>Views by tilt and distance in cm</source>
        <translation>Ansichten: Neigung, Abstand in cm</translation>
    </message>
    <message>
        <source>&amp;Views taken</source>
        <translation>Aufgenommene A&amp;nsichten</translation>
    </message>
</context>
<context>
    <name>CourseCharts</name>
    <message>
        <source>time [min:s]</source>
        <translation>Zeit [min:s]</translation>
    </message>
    <message>
        <source>Robot at rest</source>
        <translation>Roboter in Ruhe</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Halt</translation>
    </message>
    <message>
        <source>range in every %1 s</source>
        <translation>Bereich in je %1 s</translation>
    </message>
</context>
<context>
    <name>CoverageMatrix</name>
    <message>
        <source>Tilts and distances with a view: %1 of %2</source>
        <translation>Neigungen und Abstände mit einer Ansicht: %1 von %2</translation>
    </message>
</context>
<context>
    <name>EnablingButton</name>
    <message>
        <source>Hold to enable motion</source>
        <translation>Halten, um Bewegung freizugeben</translation>
    </message>
    <message>
        <source>Hold to enable motion (F11). Letting go or pressing through (Pause) stops the robot.</source>
        <translation>Halten, um Bewegung freizugeben (F11). Loslassen oder Durchdrücken (Pause) hält den Roboter an.</translation>
    </message>
    <message>
        <source>Hold to enable (F11)</source>
        <translation>Zur Freigabe halten (F11)</translation>
    </message>
    <message>
        <source>%1 (F11)</source>
        <translation>%1 (F11)</translation>
    </message>
</context>
<context>
    <name>Guidance</name>
    <message>
        <source>Bring the board %1 cm nearer.</source>
        <translation>Bringen Sie die Platte %1 cm näher heran.</translation>
    </message>
    <message>
        <source>Take the board %1 cm farther away.</source>
        <translation>Bringen Sie die Platte %1 cm weiter weg.</translation>
    </message>
    <message>
        <source>Bring the cameras %1 cm nearer to the board.</source>
        <translation>Bringen Sie die Kameras %1 cm näher an die Platte.</translation>
    </message>
    <message>
        <source>Take the cameras %1 cm farther from the board.</source>
        <translation>Bringen Sie die Kameras %1 cm weiter weg von der Platte.</translation>
    </message>
    <message>
        <source>Move it %1 cm to the left in the image.</source>
        <translation>Bewegen Sie sie im Bild %1 cm nach links.</translation>
    </message>
    <message>
        <source>Move it %1 cm to the right in the image.</source>
        <translation>Bewegen Sie sie im Bild %1 cm nach rechts.</translation>
    </message>
    <message>
        <source>Move the cameras %1 cm to the right.</source>
        <translation>Bewegen Sie die Kameras %1 cm nach rechts.</translation>
    </message>
    <message>
        <source>Move the cameras %1 cm to the left.</source>
        <translation>Bewegen Sie die Kameras %1 cm nach links.</translation>
    </message>
    <message>
        <source>Move it %1 cm up in the image.</source>
        <translation>Bewegen Sie sie im Bild %1 cm nach oben.</translation>
    </message>
    <message>
        <source>Move it %1 cm down in the image.</source>
        <translation>Bewegen Sie sie im Bild %1 cm nach unten.</translation>
    </message>
    <message>
        <source>Move the cameras %1 cm down.</source>
        <translation>Bewegen Sie die Kameras %1 cm nach unten.</translation>
    </message>
    <message>
        <source>Move the cameras %1 cm up.</source>
        <translation>Bewegen Sie die Kameras %1 cm nach oben.</translation>
    </message>
    <message>
        <source>Tilt its upper edge %1° towards the cameras.</source>
        <translation>Neigen Sie die obere Kante %1° zu den Kameras.</translation>
    </message>
    <message>
        <source>Tilt its lower edge %1° towards the cameras.</source>
        <translation>Neigen Sie die untere Kante %1° zu den Kameras.</translation>
    </message>
    <message>
        <source>Swing the cameras %1° upwards around the board.</source>
        <translation>Schwenken Sie die Kameras %1° nach oben um die Platte.</translation>
    </message>
    <message>
        <source>Swing the cameras %1° downwards around the board.</source>
        <translation>Schwenken Sie die Kameras %1° nach unten um die Platte.</translation>
    </message>
    <message>
        <source>Tilt its right edge %1° towards the cameras.</source>
        <translation>Neigen Sie die rechte Kante %1° zu den Kameras.</translation>
    </message>
    <message>
        <source>Tilt its left edge %1° towards the cameras.</source>
        <translation>Neigen Sie die linke Kante %1° zu den Kameras.</translation>
    </message>
    <message>
        <source>Swing the cameras %1° to the right around the board.</source>
        <translation>Schwenken Sie die Kameras %1° nach rechts um die Platte.</translation>
    </message>
    <message>
        <source>Swing the cameras %1° to the left around the board.</source>
        <translation>Schwenken Sie die Kameras %1° nach links um die Platte.</translation>
    </message>
    <message>
        <source>Turn it %1° clockwise in the image.</source>
        <translation>Drehen Sie sie im Bild %1° im Uhrzeigersinn.</translation>
    </message>
    <message>
        <source>Turn it %1° counter-clockwise in the image.</source>
        <translation>Drehen Sie sie im Bild %1° gegen den Uhrzeigersinn.</translation>
    </message>
    <message>
        <source>Turn the cameras %1° counter-clockwise.</source>
        <translation>Drehen Sie die Kameras %1° gegen den Uhrzeigersinn.</translation>
    </message>
    <message>
        <source>Turn the cameras %1° clockwise.</source>
        <translation>Drehen Sie die Kameras %1° im Uhrzeigersinn.</translation>
    </message>
</context>
<context>
    <name>GuidePanel</name>
    <message>
        <source>Reset stop</source>
        <translation>Halt zurücksetzen</translation>
    </message>
    <message>
        <source>Residuals of the views</source>
        <translation>Restfehler der Ansichten</translation>
    </message>
</context>
<context>
    <name>HeaderBar</name>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Reset view</source>
        <translation>Ansicht zurücksetzen</translation>
    </message>
    <message>
        <source>Camera images</source>
        <translation>Kamerabilder</translation>
    </message>
    <message>
        <source>Light or dark</source>
        <translation>Hell oder dunkel</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>No session yet</source>
        <translation>Noch keine Sitzung</translation>
    </message>
    <message>
        <source>Session %1</source>
        <translation>Sitzung %1</translation>
    </message>
</context>
<context>
    <name>HeaderFrame</name>
    <message>
        <source>SIMULATION</source>
        <translation>SIMULATION</translation>
    </message>
    <message>
        <source>Cameras and patient are simulated, and the robot unless another one was chosen</source>
        <translation>Kameras und Patient sind simuliert, und der Roboter, wenn kein anderer gewählt wurde</translation>
    </message>
</context>
<context>
    <name>HelpBars</name>
    <message>
        <source>Force at the sling and help</source>
        <translation>Kraft an der Schlinge und Hilfe</translation>
    </message>
    <message>
        <source>Force at the sling against what the plan allows, and how much the robot helps</source>
        <translation>Kraft an der Schlinge gegenüber dem, was der Plan erlaubt, und wie viel der Roboter hilft</translation>
    </message>
    <message>
        <source>Force %1, help %2</source>
        <translation>Kraft %1, Hilfe %2</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
</context>
<context>
    <name>HelpChoice</name>
    <message>
        <source>Help adapts</source>
        <translation>Hilfe adaptiv</translation>
    </message>
    <message>
        <source>Level of help that is wanted</source>
        <translation>Gewünschtes Maß der Hilfe</translation>
    </message>
    <message>
        <source>Less help</source>
        <translation>Weniger Hilfe</translation>
    </message>
    <message>
        <source>More help</source>
        <translation>Mehr Hilfe</translation>
    </message>
</context>
<context>
    <name>HelpPresenter</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>the robot is stiff</source>
        <translation>der Roboter ist steif</translation>
    </message>
</context>
<context>
    <name>JobPanel</name>
    <message>
        <source>What to calibrate</source>
        <translation>Was kalibriert wird</translation>
    </message>
    <message>
        <source>The board</source>
        <translation>Die Platte</translation>
    </message>
</context>
<context>
    <name>JointBars</name>
    <message>
        <source>Joints against their limits</source>
        <translation>Gelenke gegenüber ihren Grenzen</translation>
    </message>
    <message>
        <source>Place in range</source>
        <translation>Lage im Bereich</translation>
    </message>
    <message>
        <source>Speed / limit</source>
        <translation>Tempo / Grenze</translation>
    </message>
</context>
<context>
    <name>LightsList</name>
    <message>
        <source>Nothing is wanting</source>
        <translation>Es fehlt nichts</translation>
    </message>
    <message>
        <source>Wanting: %1</source>
        <translation>Es fehlt: %1</translation>
    </message>
</context>
<context>
    <name>LogModel</name>
    <message>
        <source>Refused: %1</source>
        <translation>Abgelehnt: %1</translation>
    </message>
    <message>
        <source>Stop reset</source>
        <translation>Halt zurückgesetzt</translation>
    </message>
</context>
<context>
    <name>LogPanel</name>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>mirrorarm – simulation</source>
        <translation>mirrorarm – Simulation</translation>
    </message>
    <message>
        <source>Alarm, %1: %2</source>
        <translation>Alarm, %1: %2</translation>
    </message>
    <message>
        <source>Report: %1</source>
        <translation>Bericht: %1</translation>
    </message>
    <message>
        <source>No report: %1</source>
        <translation>Kein Bericht: %1</translation>
    </message>
    <message>
        <source>The workstation is ready on the simulated bench</source>
        <translation>Der Arbeitsplatz ist bereit, auf dem simulierten Prüfstand</translation>
    </message>
    <message>
        <source>The workstation is ready</source>
        <translation>Der Arbeitsplatz ist bereit</translation>
    </message>
</context>
<context>
    <name>MotionPlot</name>
    <message>
        <source>Movement of both arms over time</source>
        <translation>Bewegung beider Arme über der Zeit</translation>
    </message>
</context>
<context>
    <name>MotionResult</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Over %1 stations of the robot</source>
        <translation>Über %1 Stationen des Roboters</translation>
    </message>
    <message>
        <source>Place of the board along %1, spread</source>
        <translation>Lage der Platte entlang %1, Streuung</translation>
    </message>
    <message>
        <source>Steps of the cameras against the robot&apos;s</source>
        <translation>Schritte der Kameras gegenüber denen des Roboters</translation>
    </message>
    <message>
        <source>How far the board strays over %1 views</source>
        <translation>Streuung der Plattenlage über %1 Ansichten</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>Views left out</source>
        <translation>Ausgelassene Ansichten</translation>
    </message>
    <message>
        <source>Camera on the flange</source>
        <translation>Kamera am Flansch</translation>
    </message>
    <message>
        <source>Standard deviation of its position</source>
        <translation>Standardabweichung ihrer Position</translation>
    </message>
    <message>
        <source>Its position</source>
        <translation>Ihre Position</translation>
    </message>
    <message>
        <source>%1 / %2 / %3 mm</source>
        <translation>%1 / %2 / %3 mm</translation>
    </message>
    <message>
        <source>Against the calibration in force</source>
        <translation>Gegenüber der gültigen Kalibrierung</translation>
    </message>
    <message>
        <source>Shifted by</source>
        <translation>Verschoben um</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Gedreht um</translation>
    </message>
    <message>
        <source>Clock of the cameras against the robot&apos;s</source>
        <translation>Uhr der Kameras gegenüber der des Roboters</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Its standard deviation</source>
        <translation>Seine Standardabweichung</translation>
    </message>
    <message>
        <source>Both movements agree to</source>
        <translation>Beide Bewegungen stimmen überein auf</translation>
    </message>
    <message>
        <source>Left over along the way, median</source>
        <translation>Rest entlang des Weges, Median</translation>
    </message>
    <message>
        <source>On %1 points</source>
        <translation>An %1 Punkten</translation>
    </message>
    <message>
        <source>Distance from the epipolar line</source>
        <translation>Abstand von der Epipolarlinie</translation>
    </message>
    <message>
        <source>Lengths on the board, mean error</source>
        <translation>Längen auf der Platte, mittlerer Fehler</translation>
    </message>
    <message>
        <source>Reprojection</source>
        <translation>Rückprojektion</translation>
    </message>
</context>
<context>
    <name>Overlay</name>
    <message>
        <source>cut</source>
        <translation>verdeckt</translation>
    </message>
</context>
<context>
    <name>ProgressCard</name>
    <message>
        <source>Nothing has begun</source>
        <translation>Noch nichts begonnen</translation>
    </message>
    <message>
        <source>Captured: %1 %</source>
        <translation>Aufgenommen: %1 %</translation>
    </message>
    <message>
        <source>Solving: %1 %</source>
        <translation>Berechnung: %1 %</translation>
    </message>
    <message>
        <source>Solved; nothing is in force yet</source>
        <translation>Berechnet; noch nichts ist in Kraft</translation>
    </message>
    <message>
        <source>Not solved; the views are kept</source>
        <translation>Nicht berechnet; die Ansichten bleiben erhalten</translation>
    </message>
    <message>
        <source>Written and in force</source>
        <translation>Geschrieben und in Kraft</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
</context>
<context>
    <name>QualityPanel</name>
    <message>
        <source>Markers</source>
        <translation>Marker</translation>
    </message>
    <message>
        <source>Misfit</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Rechenzeit</translation>
    </message>
    <message>
        <source>Lost frames</source>
        <translation>Verlorene Bilder</translation>
    </message>
    <message>
        <source>Refused lights</source>
        <translation>Verworfene Lichter</translation>
    </message>
    <message>
        <source>Tracking of the healthy arm</source>
        <translation>Verfolgung des gesunden Arms</translation>
    </message>
    <message>
        <source>mm from start:</source>
        <translation>mm ab Start:</translation>
    </message>
    <message>
        <source>healthy</source>
        <translation>gesund</translation>
    </message>
    <message>
        <source>impaired</source>
        <translation>betroffen</translation>
    </message>
    <message>
        <source>to goal</source>
        <translation>zum Ziel</translation>
    </message>
</context>
<context>
    <name>Quantities</name>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
</context>
<context>
    <name>Readiness</name>
    <message>
        <source>Calibration without a date</source>
        <translation>Kalibrierung ohne Datum</translation>
    </message>
    <message>
        <source>Calibrated %1</source>
        <translation>Kalibriert %1</translation>
    </message>
    <message>
        <source>Calibrations not checked today</source>
        <translation>Kalibrierungen heute nicht geprüft</translation>
    </message>
    <message>
        <source>Cameras deliver images</source>
        <translation>Kameras liefern Bilder</translation>
    </message>
    <message>
        <source>Robot answers and rests</source>
        <translation>Roboter antwortet und ruht</translation>
    </message>
    <message>
        <source>Markers in view: %1</source>
        <translation>Marker im Blick: %1</translation>
    </message>
</context>
<context>
    <name>Report</name>
    <message>
        <source>Cut off; recorded up to there</source>
        <translation>Abgebrochen; bis dahin aufgezeichnet</translation>
    </message>
    <message>
        <source>paper: %1 ms</source>
        <translation>Veröffentlichung: %1 ms</translation>
    </message>
    <message>
        <source>Lag of the robot</source>
        <translation>Verzug des Roboters</translation>
    </message>
    <message>
        <source>not determinable</source>
        <translation>nicht bestimmbar</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>% of limit</source>
        <translation>% der Grenze</translation>
    </message>
    <message>
        <source>Reach forward</source>
        <translation>Nach vorn greifen</translation>
    </message>
    <message>
        <source>Lift the arm</source>
        <translation>Arm heben</translation>
    </message>
    <message>
        <source>Move to the side</source>
        <translation>Zur Seite führen</translation>
    </message>
    <message>
        <source>Draw a circle</source>
        <translation>Kreis führen</translation>
    </message>
    <message>
        <source>Turn the forearm</source>
        <translation>Unterarm drehen</translation>
    </message>
    <message>
        <source>Free movement</source>
        <translation>Freie Bewegung</translation>
    </message>
    <message>
        <source>Same movement in space</source>
        <translation>Gleiche Bewegung im Raum</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Gespiegelt</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Not recorded</source>
        <translation>Nicht erfasst</translation>
    </message>
    <message>
        <source>Reference frame set</source>
        <translation>Bezugslage gesetzt</translation>
    </message>
    <message>
        <source>Training started</source>
        <translation>Training begonnen</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Beendet</translation>
    </message>
    <message>
        <source>Stop reset</source>
        <translation>Halt zurückgesetzt</translation>
    </message>
    <message>
        <source>Stopped: STOP was pressed</source>
        <translation>Halt: STOP wurde gedrückt</translation>
    </message>
    <message>
        <source>Stopped: the cameras delivered no images</source>
        <translation>Halt: die Kameras lieferten keine Bilder</translation>
    </message>
    <message>
        <source>Stopped: the arm was out of sight</source>
        <translation>Halt: der Arm war außer Sicht</translation>
    </message>
    <message>
        <source>Stopped: the robot did not answer</source>
        <translation>Halt: der Roboter antwortete nicht</translation>
    </message>
    <message>
        <source>Stopped: the robot reported a fault</source>
        <translation>Halt: der Roboter meldete eine Störung</translation>
    </message>
    <message>
        <source>Stopped: the motion loop missed its beat</source>
        <translation>Halt: die Bewegungsregelung kam aus dem Takt</translation>
    </message>
    <message>
        <source>Stopped: the robot was not where it was told to be</source>
        <translation>Halt: der Roboter war nicht am Sollort</translation>
    </message>
    <message>
        <source>Stopped: internal error</source>
        <translation>Halt: interner Fehler</translation>
    </message>
    <message>
        <source>Stopped: the line to the robot was too bad</source>
        <translation>Halt: die Leitung zum Roboter war zu schlecht</translation>
    </message>
    <message>
        <source>Stopped: the planning of the motion stood still</source>
        <translation>Halt: die Bewegungsplanung stand still</translation>
    </message>
    <message>
        <source>Stopped: the enabling key was let go</source>
        <translation>Halt: der Zustimmtaster wurde losgelassen</translation>
    </message>
    <message>
        <source>Stopped: the enabling key was pressed through</source>
        <translation>Halt: der Zustimmtaster wurde durchgedrückt</translation>
    </message>
    <message>
        <source>Stopped: the force at the sling became too large</source>
        <translation>Halt: die Kraft an der Schlinge wurde zu groß</translation>
    </message>
    <message>
        <source>The robot gave up its drives</source>
        <translation>Der Roboter gab seine Antriebe ab</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Impaired side</source>
        <translation>Betroffene Seite</translation>
    </message>
    <message>
        <source>Mapping</source>
        <translation>Übertragung</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Error without lag</source>
        <translation>Fehler ohne Verzug</translation>
    </message>
    <message>
        <source>rms distance to the goal</source>
        <translation>mittlerer Abstand zum Ziel (rms)</translation>
    </message>
    <message>
        <source>Error as felt</source>
        <translation>Fehler wie gespürt</translation>
    </message>
    <message>
        <source>rms, lag included</source>
        <translation>rms, mit Verzug</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Verstärkung</translation>
    </message>
    <message>
        <source>1 = same amplitude</source>
        <translation>1 = gleiche Weite</translation>
    </message>
    <message>
        <source>Repetitions</source>
        <translation>Wiederholungen</translation>
    </message>
    <message>
        <source>healthy arm, out and back</source>
        <translation>gesunder Arm, hin und zurück</translation>
    </message>
    <message>
        <source>Range of movement</source>
        <translation>Bewegungsumfang</translation>
    </message>
    <message>
        <source>healthy arm, from the start</source>
        <translation>gesunder Arm, ab Start</translation>
    </message>
    <message>
        <source>Active time</source>
        <translation>Aktive Zeit</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>robot following</source>
        <translation>Roboter folgt</translation>
    </message>
    <message>
        <source>Largest tool speed</source>
        <translation>Höchstes Tempo Werkzeug</translation>
    </message>
    <message>
        <source>m/s</source>
        <translation>m/s</translation>
    </message>
    <message>
        <source>Frames tracked</source>
        <translation>Verfolgte Bilder</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>Misfit of the target</source>
        <translation>Restfehler der Marker</translation>
    </message>
    <message>
        <source>accepted below 3 mm</source>
        <translation>zulässig unter 3 mm</translation>
    </message>
    <message>
        <source>Largest joint speed</source>
        <translation>Höchstes Gelenktempo</translation>
    </message>
    <message>
        <source>Largest joint acceleration</source>
        <translation>Höchste Gelenkbeschl.</translation>
    </message>
    <message>
        <source>Lag: the delay of the end effector that fits its path best to the goal&apos;s, over all training.</source>
        <translation>Verzug: die Verzögerung des Endeffektors, mit der sein Weg am besten auf den des Ziels passt, über das ganze Training.</translation>
    </message>
    <message>
        <source>Error without lag: rms distance between end effector and goal with that delay taken out; error as felt: the same with the delay.</source>
        <translation>Fehler ohne Verzug: mittlerer Abstand (rms) zwischen Endeffektor und Ziel, die Verzögerung herausgerechnet; Fehler wie gespürt: derselbe mit der Verzögerung.</translation>
    </message>
    <message>
        <source>Gain: slope of the end effector&apos;s displacement against the goal&apos;s.</source>
        <translation>Verstärkung: Steigung des Weges des Endeffektors über dem des Ziels.</translation>
    </message>
    <message>
        <source>Paper: Busam et al., A Stereo Vision Approach for Cooperative Robotic Movement Therapy, 2015; its figure is the delay at the start of a movement.</source>
        <translation>Veröffentlichung: Busam u. a., A Stereo Vision Approach for Cooperative Robotic Movement Therapy, 2015; dort ist es die Verzögerung am Beginn einer Bewegung.</translation>
    </message>
    <message>
        <source>Axes: x from the robot&apos;s foot towards the patient, z up.</source>
        <translation>Achsen: x vom Fuß des Roboters zum Patienten, z nach oben.</translation>
    </message>
    <message>
        <source>Help fixed at %1 %</source>
        <translation>Hilfe fest bei %1 %</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>at the sling</source>
        <translation>an der Schlinge</translation>
    </message>
    <message>
        <source>Mean help</source>
        <translation>Mittlere Hilfe</translation>
    </message>
    <message>
        <source>robot held its position</source>
        <translation>Roboter hielt Position</translation>
    </message>
    <message>
        <source>adapting %1 % of the time</source>
        <translation>angepasst in %1 % der Zeit</translation>
    </message>
    <message>
        <source>The help adapts to the patient</source>
        <translation>Die Hilfe passt sich dem Patienten an</translation>
    </message>
    <message>
        <source>Largest force: at the sling, of what the plan allows for the region of the body that it holds. Mean help: over the training; 0 % the softest, 100 % the stiffest springs of the plan.</source>
        <translation>Größte Kraft: an der Schlinge, bezogen auf das, was der Plan für die gehaltene Körperregion erlaubt. Mittlere Hilfe: über das Training; 0 % die weichsten, 100 % die steifsten Federn des Plans.</translation>
    </message>
</context>
<context>
    <name>ReportBlocks</name>
    <message>
        <source>Session report</source>
        <translation>Sitzungsbericht</translation>
    </message>
    <message>
        <source>%1 [mm]</source>
        <translation>%1 [mm]</translation>
    </message>
    <message>
        <source>Healthy arm</source>
        <translation>Gesunder Arm</translation>
    </message>
    <message>
        <source>Impaired arm (robot)</source>
        <translation>Betroffener Arm (Roboter)</translation>
    </message>
    <message>
        <source>Distance to the goal</source>
        <translation>Abstand zum Ziel</translation>
    </message>
    <message>
        <source>distance [mm]</source>
        <translation>Abstand [mm]</translation>
    </message>
    <message>
        <source>Tracking quality</source>
        <translation>Güte der Verfolgung</translation>
    </message>
    <message>
        <source>markers</source>
        <translation>Marker</translation>
    </message>
    <message>
        <source>misfit [mm]</source>
        <translation>Restfehler [mm]</translation>
    </message>
    <message>
        <source>No movement was recorded.</source>
        <translation>Es wurde keine Bewegung aufgezeichnet.</translation>
    </message>
    <message>
        <source>Movement</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Movement, a closer look</source>
        <translation>Bewegung, genauer betrachtet</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>None.</source>
        <translation>Keine.</translation>
    </message>
    <message>
        <source>Simulation: cameras and patient of this session were simulated, and the robot unless another one was chosen.</source>
        <translation>Simulation: Kameras und Patient dieser Sitzung waren simuliert, und der Roboter, wenn kein anderer gewählt wurde.</translation>
    </message>
    <message>
        <source>How the figures are made</source>
        <translation>Wie die Zahlen entstehen</translation>
    </message>
</context>
<context>
    <name>ReportBox</name>
    <message>
        <source>Make report</source>
        <translation>Bericht erstellen</translation>
    </message>
    <message>
        <source>Open report</source>
        <translation>Bericht öffnen</translation>
    </message>
    <message>
        <source>The report is being made …</source>
        <translation>Der Bericht wird erstellt …</translation>
    </message>
    <message>
        <source>Report saved as %1</source>
        <translation>Bericht gespeichert als %1</translation>
    </message>
    <message>
        <source>The report could not be made: %1</source>
        <translation>Der Bericht konnte nicht erstellt werden: %1</translation>
    </message>
</context>
<context>
    <name>ResultList</name>
    <message>
        <source>%1, good</source>
        <translation>%1, gut</translation>
    </message>
    <message>
        <source>%1, beyond its limit</source>
        <translation>%1, jenseits der Grenze</translation>
    </message>
    <message>
        <source>%1, not good enough</source>
        <translation>%1, nicht gut genug</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>In force</source>
        <translation>In Kraft</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>Gut</translation>
    </message>
</context>
<context>
    <name>ResultPage</name>
    <message>
        <source>Figures of the result</source>
        <translation>Werte des Ergebnisses</translation>
    </message>
</context>
<context>
    <name>RobotPanel</name>
    <message>
        <source>Tool speed</source>
        <translation>Werkzeugtempo</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Verzug</translation>
    </message>
    <message>
        <source>Last goal</source>
        <translation>Letztes Ziel</translation>
    </message>
    <message>
        <source>Limit met</source>
        <translation>Wirkende Grenze</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>Roboter</translation>
    </message>
    <message>
        <source>%1 mm/s</source>
        <translation>%1 mm/s</translation>
    </message>
</context>
<context>
    <name>RobotPresenter</name>
    <message>
        <source>Stopped, drives on</source>
        <translation>Halt, Antriebe an</translation>
    </message>
    <message>
        <source>Stopped, drives off</source>
        <translation>Halt, Antriebe aus</translation>
    </message>
    <message>
        <source>Soft start</source>
        <translation>Sanfter Start</translation>
    </message>
    <message>
        <source>Moving</source>
        <translation>In Bewegung</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>Hält inne</translation>
    </message>
    <message>
        <source>At rest</source>
        <translation>In Ruhe</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>stiff</source>
        <translation>steif</translation>
    </message>
    <message>
        <source>No answer</source>
        <translation>Keine Antwort</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
</context>
<context>
    <name>SceneView</name>
    <message>
        <source>3D scene</source>
        <translation>3D-Szene</translation>
    </message>
</context>
<context>
    <name>SessionPanel</name>
    <message>
        <source>Reset stop</source>
        <translation>Halt zurücksetzen</translation>
    </message>
    <message>
        <source>The impaired arm moves</source>
        <translation>Der betroffene Arm bewegt sich</translation>
    </message>
</context>
<context>
    <name>SessionPresenter</name>
    <message>
        <source>Prepare the patient</source>
        <translation>Patienten vorbereiten</translation>
    </message>
    <message>
        <source>Fasten the impaired arm in the sling and turn the markers of the healthy forearm to the cameras.</source>
        <translation>Befestigen Sie den betroffenen Arm in der Schlinge und wenden Sie die Marker des gesunden Unterarms den Kameras zu.</translation>
    </message>
    <message>
        <source>Teach the markers</source>
        <translation>Marker einlernen</translation>
    </message>
    <message>
        <source>Let the patient turn the healthy forearm slowly until every marker has been seen.</source>
        <translation>Lassen Sie den Patienten den gesunden Unterarm langsam drehen, bis jeder Marker gesehen wurde.</translation>
    </message>
    <message>
        <source>Align both arms</source>
        <translation>Beide Arme ausrichten</translation>
    </message>
    <message>
        <source>Bring both arms into the start position and hold them still. Movements count from here.</source>
        <translation>Bringen Sie beide Arme in die Ausgangslage und halten Sie sie ruhig. Bewegungen zählen von hier an.</translation>
    </message>
    <message>
        <source>Ready to train</source>
        <translation>Bereit zum Training</translation>
    </message>
    <message>
        <source>The robot moves as soon as you start. Keep a hand near STOP.</source>
        <translation>Der Roboter bewegt sich, sobald Sie starten. Halten Sie eine Hand nahe STOP.</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Training</translation>
    </message>
    <message>
        <source>The robot carries the impaired arm along with the healthy one.</source>
        <translation>Der Roboter führt den betroffenen Arm mit dem gesunden mit.</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>The robot rests. Go on, or finish the session.</source>
        <translation>Der Roboter ruht. Setzen Sie fort oder beenden Sie die Sitzung.</translation>
    </message>
    <message>
        <source>Session finished</source>
        <translation>Sitzung beendet</translation>
    </message>
    <message>
        <source>Everything is recorded. Make the report, or begin anew.</source>
        <translation>Alles ist aufgezeichnet. Erstellen Sie den Bericht oder beginnen Sie neu.</translation>
    </message>
    <message>
        <source>Markers so far: %1</source>
        <translation>Marker bisher: %1</translation>
    </message>
    <message>
        <source>%1  ·  known to %2 mm</source>
        <translation>%1  ·  bekannt auf %2 mm</translation>
    </message>
    <message>
        <source>%1 min  ·  Repetitions: %2</source>
        <translation>%1 min  ·  Wdh.: %2</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Prepare</source>
        <translation>Vorbereiten</translation>
    </message>
    <message>
        <source>Teach</source>
        <translation>Einlernen</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>Train</source>
        <translation>Trainieren</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
</context>
<context>
    <name>SessionReport</name>
    <message>
        <source>SIMULATION</source>
        <translation>SIMULATION</translation>
    </message>
    <message>
        <source>Patient %1, session %2</source>
        <translation>Patient %1, Sitzung %2</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>Session report</source>
        <translation>Sitzungsbericht</translation>
    </message>
</context>
<context>
    <name>ShortcutList</name>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
</context>
<context>
    <name>StandingLines</name>
    <message>
        <source>%1 min old</source>
        <translation>%1 min alt</translation>
    </message>
    <message>
        <source>%1 h old</source>
        <translation>%1 h alt</translation>
    </message>
    <message>
        <source>%1 days old</source>
        <translation>%1 Tage alt</translation>
    </message>
    <message>
        <source>in force, %1</source>
        <translation>in Kraft, %1</translation>
    </message>
    <message>
        <source>none in force</source>
        <translation>keine in Kraft</translation>
    </message>
    <message>
        <source>of unknown age</source>
        <translation>unbekannten Alters</translation>
    </message>
    <message>
        <source>expired, %1</source>
        <translation>abgelaufen, %1</translation>
    </message>
    <message>
        <source>doubtful, %1</source>
        <translation>zweifelhaft, %1</translation>
    </message>
    <message>
        <source>failed, %1</source>
        <translation>nicht bestanden, %1</translation>
    </message>
</context>
<context>
    <name>StepRail</name>
    <message>
        <source>Step %1 of %2: %3</source>
        <translation>Schritt %1 von %2: %3</translation>
    </message>
</context>
<context>
    <name>StereoImageView</name>
    <message>
        <source>Refused lights</source>
        <translation>Verworfene Lichter</translation>
    </message>
    <message>
        <source>Camera images</source>
        <translation>Kamerabilder</translation>
    </message>
    <message>
        <source>Click to enlarge (Ctrl+I)
Dashed: partly covered. Dotted with ?: several partners possible</source>
        <translation>Zum Vergrößern klicken (Strg+I)
Gestrichelt: teilweise verdeckt. Gepunktet mit ?: mehrere Partner möglich</translation>
    </message>
    <message>
        <source>Show refused lights</source>
        <translation>Verworfene Lichter zeigen</translation>
    </message>
    <message>
        <source>Say of every light why it is no marker (%1)</source>
        <translation>Zu jedem Licht sagen, warum es kein Marker ist (%1)</translation>
    </message>
    <message>
        <source>No images yet</source>
        <translation>Noch keine Bilder</translation>
    </message>
    <message>
        <source>Left camera</source>
        <translation>Linke Kamera</translation>
    </message>
    <message>
        <source>Right camera</source>
        <translation>Rechte Kamera</translation>
    </message>
    <message>
        <source>Close-up, left</source>
        <translation>Nahaufnahme, links</translation>
    </message>
</context>
<context>
    <name>StereoResult</name>
    <message>
        <source>On %1 views kept out</source>
        <translation>An %1 zurückgehaltenen Ansichten</translation>
    </message>
    <message>
        <source>Each of %1 views kept out in turn</source>
        <translation>Jede von %1 Ansichten reihum zurückgehalten</translation>
    </message>
    <message>
        <source>Distance from the epipolar line</source>
        <translation>Abstand von der Epipolarlinie</translation>
    </message>
    <message>
        <source>Lengths on the board, mean error</source>
        <translation>Längen auf der Platte, mittlerer Fehler</translation>
    </message>
    <message>
        <source>Lengths on the board, spread</source>
        <translation>Längen auf der Platte, Streuung</translation>
    </message>
    <message>
        <source>Reprojection, each view by itself</source>
        <translation>Rückprojektion, jede Ansicht für sich</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>On the %1 views of the solution</source>
        <translation>An den %1 Ansichten der Lösung</translation>
    </message>
    <message>
        <source>Reprojection</source>
        <translation>Rückprojektion</translation>
    </message>
    <message>
        <source>Views left out</source>
        <translation>Ausgelassene Ansichten</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1, reprojection of views kept out</source>
        <translation>%1, Rückprojektion zurückgehaltener Ansichten</translation>
    </message>
    <message>
        <source>Lens model</source>
        <translation>Linsenmodell</translation>
    </message>
    <message>
        <source>Against the calibration in force</source>
        <translation>Gegenüber der gültigen Kalibrierung</translation>
    </message>
    <message>
        <source>Distance from the epipolar line, same views</source>
        <translation>Abstand von der Epipolarlinie, gleiche Ansichten</translation>
    </message>
    <message>
        <source>Cameras turned to each other</source>
        <translation>Kameras zueinander gedreht</translation>
    </message>
    <message>
        <source>Cameras shifted to each other</source>
        <translation>Kameras zueinander verschoben</translation>
    </message>
    <message>
        <source>Focal lengths changed by</source>
        <translation>Brennweiten geändert um</translation>
    </message>
    <message>
        <source>Depth at %1 m changes by</source>
        <translation>Tiefe bei %1 m ändert sich um</translation>
    </message>
    <message>
        <source>Standard deviations</source>
        <translation>Standardabweichungen</translation>
    </message>
    <message>
        <source>Turn between the cameras</source>
        <translation>Drehung zwischen den Kameras</translation>
    </message>
    <message>
        <source>Shift between the cameras</source>
        <translation>Verschiebung zwischen den Kameras</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>Focal length, %1</source>
        <translation>Brennweite, %1</translation>
    </message>
    <message>
        <source>Principal point, %1</source>
        <translation>Bildhauptpunkt, %1</translation>
    </message>
    <message>
        <source>The board itself</source>
        <translation>Die Platte selbst</translation>
    </message>
    <message>
        <source>Bent: replace it</source>
        <translation>Verbogen: ersetzen</translation>
    </message>
    <message>
        <source>Flat to</source>
        <translation>Eben auf</translation>
    </message>
    <message>
        <source>Stretched along one side: print it anew</source>
        <translation>Entlang einer Seite gestreckt: neu drucken</translation>
    </message>
    <message>
        <source>Both sides to the same scale to</source>
        <translation>Beide Seiten im selben Maßstab auf</translation>
    </message>
</context>
<context>
    <name>StopButton</name>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Brings the robot to rest at once. Escape key.</source>
        <translation>Bringt den Roboter sofort zur Ruhe. Escape-Taste.</translation>
    </message>
    <message>
        <source>Brings the robot to rest at once (Esc)</source>
        <translation>Bringt den Roboter sofort zur Ruhe (Esc)</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
</context>
<context>
    <name>Summary</name>
    <message>
        <source>Mean help</source>
        <translation>Mittlere Hilfe</translation>
    </message>
    <message>
        <source>Range of the healthy arm</source>
        <translation>Umfang gesunder Arm</translation>
    </message>
    <message>
        <source>Delay of the robot</source>
        <translation>Verzug des Roboters</translation>
    </message>
    <message>
        <source>Error without delay</source>
        <translation>Fehler ohne Verzug</translation>
    </message>
    <message>
        <source>Error with delay</source>
        <translation>Fehler mit Verzug</translation>
    </message>
    <message>
        <source>Largest force, of its limit</source>
        <translation>Größte Kraft, von der Grenze</translation>
    </message>
    <message>
        <source>Time of adapting help</source>
        <translation>Zeit mit Anpassung</translation>
    </message>
</context>
<context>
    <name>TrackingPresenter</name>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Not taught</source>
        <translation>Nicht eingelernt</translation>
    </message>
    <message>
        <source>markers in view: %1</source>
        <translation>Marker im Blick: %1</translation>
    </message>
    <message>
        <source>%1: good light</source>
        <translation>%1: gutes Licht</translation>
    </message>
    <message>
        <source>Good light in both images</source>
        <translation>Gutes Licht in beiden Bildern</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>No images</source>
        <translation>Keine Bilder</translation>
    </message>
    <message>
        <source>the cameras are silent</source>
        <translation>die Kameras schweigen</translation>
    </message>
    <message>
        <source>Tracking: %1, markers %2, misfit %3</source>
        <translation>Verfolgung: %1, Marker %2, Restfehler %3</translation>
    </message>
</context>
<context>
    <name>ViewList</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>⚠ left out</source>
        <translation>⚠ ausgelassen</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Restfehler</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Anmerkung</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>The operator pressed STOP</source>
        <translation>Die Bedienperson hat STOP gedrückt</translation>
    </message>
    <message>
        <source>The cameras deliver no images</source>
        <translation>Die Kameras liefern keine Bilder</translation>
    </message>
    <message>
        <source>The arm target was lost</source>
        <translation>Das Armziel ging verloren</translation>
    </message>
    <message>
        <source>The robot does not answer</source>
        <translation>Der Roboter antwortet nicht</translation>
    </message>
    <message>
        <source>The robot reports a fault</source>
        <translation>Der Roboter meldet eine Störung</translation>
    </message>
    <message>
        <source>The motion loop missed its beat</source>
        <translation>Die Bewegungsregelung kam aus dem Takt</translation>
    </message>
    <message>
        <source>The robot is not where it was told to be</source>
        <translation>Der Roboter ist nicht am Sollort</translation>
    </message>
    <message>
        <source>An internal error ended the motion</source>
        <translation>Ein interner Fehler beendete die Bewegung</translation>
    </message>
    <message>
        <source>The line to the robot is too bad</source>
        <translation>Die Leitung zum Roboter ist zu schlecht</translation>
    </message>
    <message>
        <source>The planning of the motion stood still</source>
        <translation>Die Bewegungsplanung stand still</translation>
    </message>
    <message>
        <source>The enabling key was let go</source>
        <translation>Der Zustimmtaster wurde losgelassen</translation>
    </message>
    <message>
        <source>The enabling key was pressed through</source>
        <translation>Der Zustimmtaster wurde durchgedrückt</translation>
    </message>
    <message>
        <source>The force at the sling became too large</source>
        <translation>Die Kraft an der Schlinge wurde zu groß</translation>
    </message>
    <message>
        <source>Make sure that the patient is well. Then reset the stop; nothing moves by that.</source>
        <translation>Vergewissern Sie sich, dass es dem Patienten gut geht. Setzen Sie dann den Halt zurück; dadurch bewegt sich nichts.</translation>
    </message>
    <message>
        <source>Check the camera cables and power, then reset the stop.</source>
        <translation>Prüfen Sie Kabel und Stromversorgung der Kameras, setzen Sie dann den Halt zurück.</translation>
    </message>
    <message>
        <source>Bring the markers of the healthy arm back into view, then reset the stop.</source>
        <translation>Bringen Sie die Marker des gesunden Arms wieder in den Blick, setzen Sie dann den Halt zurück.</translation>
    </message>
    <message>
        <source>Look at the robot controller and clear its fault, then reset the stop.</source>
        <translation>Sehen Sie nach der Robotersteuerung und beheben Sie deren Störung, setzen Sie dann den Halt zurück.</translation>
    </message>
    <message>
        <source>Make sure that nothing holds the robot, then reset the stop.</source>
        <translation>Vergewissern Sie sich, dass nichts den Roboter festhält, setzen Sie dann den Halt zurück.</translation>
    </message>
    <message>
        <source>Check the network cable to the robot controller, then reset the stop.</source>
        <translation>Prüfen Sie das Netzwerkkabel zur Robotersteuerung, setzen Sie dann den Halt zurück.</translation>
    </message>
    <message>
        <source>Close other programs. If it comes again, call the engineer.</source>
        <translation>Schließen Sie andere Programme. Tritt es erneut auf, rufen Sie den technischen Dienst.</translation>
    </message>
    <message>
        <source>Reset the stop, hold the enabling key and start again.</source>
        <translation>Setzen Sie den Halt zurück, halten Sie den Zustimmtaster und starten Sie erneut.</translation>
    </message>
    <message>
        <source>Make sure that the patient is well. Let the enabling key go fully, then reset the stop.</source>
        <translation>Vergewissern Sie sich, dass es dem Patienten gut geht. Lassen Sie den Zustimmtaster ganz los, setzen Sie dann den Halt zurück.</translation>
    </message>
    <message>
        <source>Free the patient&apos;s arm from the strain and ask whether anything hurts, then reset the stop.</source>
        <translation>Entlasten Sie den Arm des Patienten und fragen Sie, ob etwas schmerzt, setzen Sie dann den Halt zurück.</translation>
    </message>
    <message>
        <source>The stop can be reset once the robot is at rest</source>
        <translation>Der Halt kann zurückgesetzt werden, sobald der Roboter ruht</translation>
    </message>
    <message>
        <source>The stop cannot be reset yet: %1</source>
        <translation>Der Halt kann noch nicht zurückgesetzt werden: %1</translation>
    </message>
    <message>
        <source>Released</source>
        <translation>Losgelassen</translation>
    </message>
    <message>
        <source>Enabled</source>
        <translation>Freigegeben</translation>
    </message>
    <message>
        <source>Pressed through</source>
        <translation>Durchgedrückt</translation>
    </message>
    <message>
        <source>The help adapts to the patient</source>
        <translation>Die Hilfe passt sich dem Patienten an</translation>
    </message>
    <message>
        <source>Help fixed at %1 %</source>
        <translation>Hilfe fest bei %1 %</translation>
    </message>
    <message>
        <source>Accepted</source>
        <translation>Angenommen</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Not enabled</source>
        <translation>Nicht freigegeben</translation>
    </message>
    <message>
        <source>Begins elsewhere</source>
        <translation>Beginnt anderswo</translation>
    </message>
    <message>
        <source>Robot not ready</source>
        <translation>Roboter nicht bereit</translation>
    </message>
    <message>
        <source>The sling</source>
        <translation>Die Schlinge</translation>
    </message>
    <message>
        <source>The camera bar</source>
        <translation>Der Kamerabalken</translation>
    </message>
    <message>
        <source>The arm</source>
        <translation>Der Roboterarm</translation>
    </message>
    <message>
        <source>%1 would touch the arm</source>
        <translation>%1 würde den Roboterarm berühren</translation>
    </message>
    <message>
        <source>%1 would come too near the head</source>
        <translation>%1 käme dem Kopf zu nahe</translation>
    </message>
    <message>
        <source>%1 would touch the table</source>
        <translation>%1 würde den Tisch berühren</translation>
    </message>
    <message>
        <source>%1 would touch: %2</source>
        <translation>%1 würde berühren: %2</translation>
    </message>
    <message>
        <source>Direct way</source>
        <translation>Direkter Weg</translation>
    </message>
    <message>
        <source>Planned detour</source>
        <translation>Geplanter Umweg</translation>
    </message>
    <message>
        <source>Planning a detour</source>
        <translation>Umweg in Planung</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>Hält inne</translation>
    </message>
    <message>
        <source>Goal out of reach</source>
        <translation>Ziel außer Reichweite</translation>
    </message>
    <message>
        <source>Way is blocked</source>
        <translation>Weg versperrt</translation>
    </message>
    <message>
        <source>Joint step too large</source>
        <translation>Gelenkschritt zu groß</translation>
    </message>
    <message>
        <source>Within limits</source>
        <translation>In den Grenzen</translation>
    </message>
    <message>
        <source>Braked: invalid command</source>
        <translation>Gebremst: ungültiger Befehl</translation>
    </message>
    <message>
        <source>Braked: robot is not where it should be</source>
        <translation>Gebremst: Roboter nicht am Sollort</translation>
    </message>
    <message>
        <source>Joint range</source>
        <translation>Gelenkbereich</translation>
    </message>
    <message>
        <source>Close to an obstacle</source>
        <translation>Hindernis nahe</translation>
    </message>
    <message>
        <source>Joint jerk</source>
        <translation>Gelenkruck</translation>
    </message>
    <message>
        <source>Joint acceleration</source>
        <translation>Gelenkbeschl.</translation>
    </message>
    <message>
        <source>Joint speed</source>
        <translation>Gelenktempo</translation>
    </message>
    <message>
        <source>Slow near the head</source>
        <translation>Langsam am Kopf</translation>
    </message>
    <message>
        <source>Tool speed</source>
        <translation>Werkzeugtempo</translation>
    </message>
    <message>
        <source>Tool acceleration</source>
        <translation>Werkzeugbeschl.</translation>
    </message>
    <message>
        <source>Not possible in this step</source>
        <translation>In diesem Schritt nicht möglich</translation>
    </message>
    <message>
        <source>Reset the stop first</source>
        <translation>Setzen Sie zuerst den Halt zurück</translation>
    </message>
    <message>
        <source>Hold the enabling key, then start</source>
        <translation>Halten Sie den Zustimmtaster, starten Sie dann</translation>
    </message>
    <message>
        <source>The arm target is not in view</source>
        <translation>Das Armziel ist nicht im Blick</translation>
    </message>
    <message>
        <source>The calibration does not hold: calibrate, or check it, before a session</source>
        <translation>Die Kalibrierung gilt nicht: vor einer Sitzung kalibrieren oder prüfen</translation>
    </message>
    <message>
        <source>At least three markers that are not on one line must be seen</source>
        <translation>Mindestens drei Marker, die nicht auf einer Geraden liegen, müssen gesehen werden</translation>
    </message>
    <message>
        <source>The robot holds its position stiffly</source>
        <translation>Der Roboter hält seine Position steif</translation>
    </message>
    <message>
        <source>The help lies between 0 and 100 %</source>
        <translation>Die Hilfe liegt zwischen 0 und 100 %</translation>
    </message>
    <message>
        <source>The station is busy. Ask again</source>
        <translation>Die Station ist beschäftigt. Versuchen Sie es erneut</translation>
    </message>
    <message>
        <source>Not recording</source>
        <translation>Keine Aufzeichnung</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung läuft</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Aufgezeichnet</translation>
    </message>
    <message>
        <source>Recording failed</source>
        <translation>Aufzeichnung gescheitert</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Parallel</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Gespiegelt</translation>
    </message>
    <message>
        <source>Preparing</source>
        <translation>Vorbereitung</translation>
    </message>
    <message>
        <source>Teaching</source>
        <translation>Einlernen</translation>
    </message>
    <message>
        <source>Target taught</source>
        <translation>Ziel eingelernt</translation>
    </message>
    <message>
        <source>Aligned</source>
        <translation>Ausgerichtet</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Training</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Beendet</translation>
    </message>
    <message>
        <source>Teach markers</source>
        <translation>Marker einlernen</translation>
    </message>
    <message>
        <source>Keep these markers</source>
        <translation>Diese Marker behalten</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>Ausrichten</translation>
    </message>
    <message>
        <source>Start training</source>
        <translation>Training starten</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Finish session</source>
        <translation>Sitzung beenden</translation>
    </message>
    <message>
        <source>New session</source>
        <translation>Neue Sitzung</translation>
    </message>
    <message>
        <source>Tracked</source>
        <translation>Verfolgt</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>Vorhergesagt</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Verloren</translation>
    </message>
    <message>
        <source>no markers in view</source>
        <translation>keine Marker im Blick</translation>
    </message>
    <message>
        <source>too few markers in view</source>
        <translation>zu wenige Marker im Blick</translation>
    </message>
    <message>
        <source>markers do not fit the model</source>
        <translation>Marker passen nicht zum Modell</translation>
    </message>
    <message>
        <source>pose not found</source>
        <translation>Lage nicht gefunden</translation>
    </message>
    <message>
        <source>markers fit in several ways</source>
        <translation>Marker passen auf mehrere Weisen</translation>
    </message>
    <message>
        <source>outside the cameras&apos; view</source>
        <translation>außerhalb des Blickfelds</translation>
    </message>
    <message>
        <source>not seen for too long</source>
        <translation>zu lange nicht gesehen</translation>
    </message>
    <message>
        <source>The sleeve has slipped; the markers were taught anew</source>
        <translation>Die Manschette ist verrutscht; die Marker wurden neu eingelernt</translation>
    </message>
    <message>
        <source>A marker has fallen off</source>
        <translation>Ein Marker ist abgefallen</translation>
    </message>
    <message>
        <source>A marker is back</source>
        <translation>Ein Marker ist wieder da</translation>
    </message>
    <message>
        <source>A new marker moves with the arm; it was added</source>
        <translation>Ein neuer Marker bewegt sich mit dem Arm; er wurde aufgenommen</translation>
    </message>
    <message>
        <source>too small</source>
        <translation>zu klein</translation>
    </message>
    <message>
        <source>too large</source>
        <translation>zu groß</translation>
    </message>
    <message>
        <source>too long</source>
        <translation>zu lang</translation>
    </message>
    <message>
        <source>not round</source>
        <translation>nicht rund</translation>
    </message>
    <message>
        <source>at the border</source>
        <translation>am Rand</translation>
    </message>
    <message>
        <source>too bright</source>
        <translation>zu hell</translation>
    </message>
    <message>
        <source>mostly covered</source>
        <translation>meist verdeckt</translation>
    </message>
    <message>
        <source>bright background</source>
        <translation>heller Hintergrund</translation>
    </message>
    <message>
        <source>too dark</source>
        <translation>zu dunkel</translation>
    </message>
    <message>
        <source>shorten the exposure</source>
        <translation>kürzer belichten</translation>
    </message>
    <message>
        <source>shut out daylight</source>
        <translation>Tageslicht aussperren</translation>
    </message>
    <message>
        <source>uncover it or expose longer</source>
        <translation>aufdecken oder länger belichten</translation>
    </message>
    <message>
        <source>Not stopped</source>
        <translation>Kein Halt</translation>
    </message>
</context>
</TS>
