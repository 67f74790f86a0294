<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
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
        <source>Simulation: cameras, robot and arms of this session were simulated.</source>
        <translation>Simulation: Kameras, Roboter und Arme dieser Sitzung waren simuliert.</translation>
    </message>
    <message>
        <source>How the figures are made</source>
        <translation>Wie die Zahlen entstehen</translation>
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
</TS>
