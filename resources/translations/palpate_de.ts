<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Messages</name>
    <message>
        <source>The isovalue %1 is at or below the background %2, where everything would be solid; choose a higher one.</source>
        <translation>Der Isowert %1 liegt nicht über dem Hintergrund %2, wo alles fest wäre; wählen Sie einen höheren.</translation>
    </message>
    <message>
        <source>The tool is up to %1 mm long, which is unusual; the points are taken to be in metres.</source>
        <translation>Das Werkzeug ist bis zu %1 mm lang, was ungewöhnlich ist; die Punkte werden in Metern verstanden.</translation>
    </message>
    <message>
        <source>The first line of &quot;%1&quot; holds numbers, where the columns&apos; names belong, and would be lost; write a line of names above it.</source>
        <translation>In der ersten Zeile von „%1“ stehen Zahlen, wo die Namen der Spalten hingehören; sie gingen verloren. Schreiben Sie eine Zeile mit Namen darüber.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs %2 numbers, separated by commas, in line %3.</source>
        <translation>„%1“ braucht %2 durch Kommas getrennte Zahlen in Zeile %3.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was saved by an earlier Palpate, in a version of views that this one does not read; use that one.</source>
        <translation>„%1“ wurde von einem früheren Palpate gespeichert, in einer Version der Ansichten, die dieses nicht liest; verwenden Sie jenes.</translation>
    </message>
    <message>
        <source>The measurement was cancelled.</source>
        <translation>Die Messung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>There is no scan named %1.</source>
        <translation>Es gibt keine Aufnahme namens %1.</translation>
    </message>
    <message>
        <source>Polhem and WoodenHaptics have the same boards: connect the arm that it is, or it is pushed in wrong directions.</source>
        <translation>Polhem und WoodenHaptics haben die gleichen Platinen: Verbinden Sie den Arm, der es wirklich ist, sonst wird er in falsche Richtungen gedrückt.</translation>
    </message>
    <message>
        <source>The board of the %1 has firmware of before October 2019, which is not supported; load a newer one of its makers.</source>
        <translation>Die Platine von %1 hat eine Firmware von vor Oktober 2019, die nicht unterstützt wird; laden Sie eine neuere ihrer Hersteller.</translation>
    </message>
    <message>
        <source>What is plugged in does not answer as a %1 does; switch its power on, or unplug the other device that has its USB ids.</source>
        <translation>Was angeschlossen ist, antwortet nicht wie %1; schalten Sie es ein, oder ziehen Sie das andere Gerät ab, das seine USB-Kennung hat.</translation>
    </message>
    <message>
        <source>There is no device &apos;%1&apos;; `palpate-cli devices` lists those that are known.</source>
        <translation>Es gibt kein Gerät „%1“; „palpate-cli devices“ nennt die bekannten.</translation>
    </message>
    <message>
        <source>The Novint Falcon has had no firmware since it was switched on; choose the firmware file that came with the Falcon&apos;s own software.</source>
        <translation>Der Novint Falcon hat seit dem Einschalten keine Firmware; wählen Sie die Firmwaredatei aus der Software, die dem Falcon beilag.</translation>
    </message>
    <message>
        <source>The Novint Falcon does not answer; see that its power supply is plugged in, switch it off and on, and open it again.</source>
        <translation>Der Novint Falcon antwortet nicht; prüfen Sie, ob sein Netzteil eingesteckt ist, schalten Sie ihn aus und ein und öffnen Sie ihn noch einmal.</translation>
    </message>
    <message>
        <source>The Novint Falcon did not take its firmware whole; plug it into a port of the computer itself, or into a hub with a power supply, and open it again.</source>
        <translation>Der Novint Falcon hat seine Firmware nicht vollständig angenommen; stecken Sie ihn direkt am Computer an oder an einem Hub mit Netzteil, und öffnen Sie ihn noch einmal.</translation>
    </message>
    <message>
        <source>The Novint Falcon took &apos;%1&apos;, but does not run it; switch it off and on, and choose the firmware file that came with the Falcon&apos;s own software.</source>
        <translation>Der Novint Falcon hat „%1“ angenommen, führt es aber nicht aus; schalten Sie ihn aus und ein, und wählen Sie die Firmwaredatei aus der Software, die dem Falcon beilag.</translation>
    </message>
    <message>
        <source>The Force Dimension SDK is of version %1.%2.%3, and Palpate knows 3.3.2 to 3.x; install one of these from its maker&apos;s site.</source>
        <translation>Das SDK von Force Dimension hat die Version %1.%2.%3, und Palpate kennt 3.3.2 bis 3.x; installieren Sie eine davon von der Website des Herstellers.</translation>
    </message>
    <message>
        <source>The Force Dimension device is of model number %1, which Palpate does not know; tell its makers the number.</source>
        <translation>Das Gerät von Force Dimension hat die Modellnummer %1, die Palpate nicht kennt; nennen Sie den Entwicklern die Nummer.</translation>
    </message>
    <message>
        <source>The %1 does not take a watchdog, without which its force would stay on when a program dies; update its firmware.</source>
        <translation>%1 nimmt keine Zeitüberwachung an; ohne sie bliebe die Kraft eingeschaltet, wenn ein Programm abstürzt. Aktualisieren Sie die Firmware.</translation>
    </message>
    <message>
        <source>The Force Dimension device does not answer; switch it on, and see that Palpate&apos;s rules for devices, 70-palpate.rules, are installed.</source>
        <translation>Das Gerät von Force Dimension antwortet nicht; schalten Sie es ein, und prüfen Sie, ob Palpates Geräteregeln, 70-palpate.rules, installiert sind.</translation>
    </message>
    <message>
        <source>Opening it tells which model it is.</source>
        <translation>Erst das Öffnen zeigt, welches Modell es ist.</translation>
    </message>
    <message>
        <source>The system does not let you use the %1; install Palpate&apos;s rules for devices, 70-palpate.rules, and plug it in again.</source>
        <translation>Das System lässt Sie %1 nicht verwenden; installieren Sie Palpates Geräteregeln, 70-palpate.rules, und stecken Sie das Gerät wieder an.</translation>
    </message>
    <message>
        <source>Another program, or another part of Palpate, uses the %1; close that one first.</source>
        <translation>Ein anderes Programm oder ein anderer Teil von Palpate verwendet %1; schließen Sie dies zuerst.</translation>
    </message>
    <message>
        <source>The %1 is gone; plug it in again.</source>
        <translation>%1 ist weg; stecken Sie das Gerät wieder an.</translation>
    </message>
    <message>
        <source>The Haply Inverse3 has no power; plug in its power supply.</source>
        <translation>Der Haply Inverse3 hat keinen Strom; stecken Sie sein Netzteil ein.</translation>
    </message>
    <message>
        <source>The Haply Inverse3 is not ready; wait, or switch it off and on.</source>
        <translation>Der Haply Inverse3 ist nicht bereit; warten Sie, oder schalten Sie ihn aus und ein.</translation>
    </message>
    <message>
        <source>The Haply Inverse3 is not calibrated; put its handle in the inkwell until its light says that it is.</source>
        <translation>Der Haply Inverse3 ist nicht kalibriert; stellen Sie seinen Griff in die Halterung, bis sein Licht zeigt, dass er es ist.</translation>
    </message>
    <message>
        <source>The service of the Haply Inverse3 does not answer; install and start its maker&apos;s haply-inverse-service.</source>
        <translation>Der Dienst des Haply Inverse3 antwortet nicht; installieren und starten Sie den haply-inverse-service des Herstellers.</translation>
    </message>
    <message>
        <source>The service of the Haply Inverse3 speaks in a way that Palpate does not know; install version 3.5 of haply-inverse-service.</source>
        <translation>Der Dienst des Haply Inverse3 spricht auf eine Weise, die Palpate nicht kennt; installieren Sie Version 3.5 von haply-inverse-service.</translation>
    </message>
    <message>
        <source>No Haply Inverse3 is connected; plug in its cable and its power supply, and look for it in Haply Hub.</source>
        <translation>Kein Haply Inverse3 ist verbunden; stecken Sie sein Kabel und sein Netzteil an, und suchen Sie ihn in Haply Hub.</translation>
    </message>
    <message>
        <source>The Haply Inverse3 %1 is set to other axes than its maker&apos;s; set its basis to XYZ in Haply Hub.</source>
        <translation>Der Haply Inverse3 %1 ist auf andere Achsen gestellt als die des Herstellers; stellen Sie seine Basis in Haply Hub auf XYZ.</translation>
    </message>
    <message>
        <source>OpenHaptics finds no valid licence; run its licence tool, or install the developer edition from 3D Systems&apos; site.</source>
        <translation>OpenHaptics findet keine gültige Lizenz; starten Sie sein Lizenzprogramm, oder installieren Sie die Entwicklerausgabe von der Website von 3D Systems.</translation>
    </message>
    <message>
        <source>The Touch or PHANTOM does not answer; see that it is plugged in and switched on, that Palpate&apos;s rules for devices, 70-palpate.rules, are installed, and pair it in the maker&apos;s setup tool.</source>
        <translation>Der Touch oder PHANTOM antwortet nicht; prüfen Sie, ob er angeschlossen und eingeschaltet ist und ob Palpates Geräteregeln, 70-palpate.rules, installiert sind, und koppeln Sie ihn im Einrichtungsprogramm des Herstellers.</translation>
    </message>
    <message>
        <source>OpenHaptics finds no Touch or PHANTOM; plug it in, switch it on, and set it up with the maker&apos;s setup tool.</source>
        <translation>OpenHaptics findet keinen Touch oder PHANTOM; stecken Sie ihn an, schalten Sie ihn ein, und richten Sie ihn mit dem Programm des Herstellers ein.</translation>
    </message>
    <message>
        <source>OpenHaptics is installed; opening tells whether a device is there.</source>
        <translation>OpenHaptics ist installiert; erst das Öffnen zeigt, ob ein Gerät da ist.</translation>
    </message>
    <message>
        <source>The service spacenavd does not answer at &apos;%1&apos;; start it, or use the SpaceMouse without it.</source>
        <translation>Der Dienst spacenavd antwortet bei „%1“ nicht; starten Sie ihn, oder verwenden Sie die SpaceMouse ohne ihn.</translation>
    </message>
    <message>
        <source>The system does not let you use the service spacenavd at &apos;%1&apos;; let your user read and write that socket.</source>
        <translation>Das System lässt Sie den Dienst spacenavd bei „%1“ nicht verwenden; erlauben Sie Ihrem Benutzer, diesen Socket zu lesen und zu schreiben.</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no regular file, and is not written over; name a file.</source>
        <translation>„%1“ ist keine gewöhnliche Datei und wird nicht überschrieben; nennen Sie eine Datei.</translation>
    </message>
    <message>
        <source>The volume is not the one that was recorded: its voxels are others, or lie elsewhere; give the one that was touched, or none.</source>
        <translation>Das Volumen ist nicht das aufgezeichnete: Seine Voxel sind andere oder liegen anderswo; nennen Sie das Volumen, das berührt wurde, oder keines.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; names a folder; add how the files&apos; names begin, such as sub-01_task-touch.</source>
        <translation>„%1“ nennt einen Ordner; fügen Sie hinzu, wie die Namen der Dateien beginnen, etwa sub-01_task-touch.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written; check that its folder exists, may be written to and has room.</source>
        <translation>„%1“ lässt sich nicht schreiben; prüfen Sie, ob der Ordner besteht, beschreibbar ist und Platz hat.</translation>
    </message>
    <message>
        <source>The recording has no step in that stretch of time; choose another.</source>
        <translation>Die Aufzeichnung hat in dieser Zeitspanne keinen Schritt; wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>The film would have more than a million frames; take a shorter stretch, or a greater speed.</source>
        <translation>Der Film hätte mehr als eine Million Bilder; nehmen Sie eine kürzere Spanne oder eine größere Geschwindigkeit.</translation>
    </message>
    <message>
        <source>There is no X display to draw a film on; set DISPLAY, or where there is no screen put &quot;xvfb-run -a&quot; before the command.</source>
        <translation>Es gibt keine X-Anzeige, auf der ein Film gezeichnet werden kann; setzen Sie DISPLAY, oder stellen Sie ohne Bildschirm „xvfb-run -a“ vor den Befehl.</translation>
    </message>
    <message>
        <source>This display has no OpenGL 3.2, which a film is drawn with; use another, or put &quot;xvfb-run -a&quot; before the command.</source>
        <translation>Diese Anzeige hat kein OpenGL 3.2, womit ein Film gezeichnet wird; verwenden Sie eine andere, oder stellen Sie „xvfb-run -a“ vor den Befehl.</translation>
    </message>
    <message>
        <source>The film could not be written; check the room on the disk.</source>
        <translation>Der Film ließ sich nicht schreiben; prüfen Sie den Platz auf dem Datenträger.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no host and port; write it as pacs.example.org:104.</source>
        <translation>„%1“ ist kein Host mit Port; schreiben Sie ihn wie pacs.example.org:104.</translation>
    </message>
    <message>
        <source>Name one server: --dicomweb with a URL, or --dimse with host and port.</source>
        <translation>Nennen Sie einen Server: --dicomweb mit einer URL oder --dimse mit Host und Port.</translation>
    </message>
    <message>
        <source>A server of DIMSE has an AE title; name it with --called.</source>
        <translation>Ein DIMSE-Server hat einen AE-Titel; nennen Sie ihn mit --called.</translation>
    </message>
    <message>
        <source>A login belongs to DICOMweb; DIMSE knows this program by its AE title, and by its certificate with --tls.</source>
        <translation>Eine Anmeldung gehört zu DICOMweb; DIMSE kennt dieses Programm an seinem AE-Titel und mit --tls an seinem Zertifikat.</translation>
    </message>
    <message>
        <source>--called, --tls and --move belong to DIMSE; a server of DICOMweb has a URL alone.</source>
        <translation>--called, --tls und --move gehören zu DIMSE; ein DICOMweb-Server hat nur eine URL.</translation>
    </message>
    <message>
        <source>A certificate needs its private key: give --certificate and --key.</source>
        <translation>Ein Zertifikat braucht seinen privaten Schlüssel: Geben Sie --certificate und --key an.</translation>
    </message>
    <message>
        <source>Name a new folder for the images with --out; without one, a parent program must hold standard input (--attached).</source>
        <translation>Nennen Sie mit --out einen neuen Ordner für die Bilder; ohne ihn muss ein übergeordnetes Programm die Standardeingabe halten (--attached).</translation>
    </message>
    <message>
        <source>The URL of a server of DICOMweb is https:// or http:// with a host and a path, without user, password and query.</source>
        <translation>Die URL eines DICOMweb-Servers ist https:// oder http:// mit Host und Pfad, ohne Benutzer, Passwort und Abfrageteil.</translation>
    </message>
    <message>
        <source>The login was not sent to &quot;%1&quot;: without https everybody between could read it; use the server&apos;s https address.</source>
        <translation>Die Anmeldung wurde nicht an „%1“ gesendet: Ohne https könnte sie unterwegs jeder lesen; verwenden Sie die https-Adresse des Servers.</translation>
    </message>
    <message>
        <source>Standard input has no login; give {&quot;login&quot;: {&quot;user&quot;, &quot;password&quot;}} or {&quot;login&quot;: {&quot;token&quot;}}.</source>
        <translation>Die Standardeingabe enthält keine Anmeldung; geben Sie {&quot;login&quot;: {&quot;user&quot;, &quot;password&quot;}} oder {&quot;login&quot;: {&quot;token&quot;}} an.</translation>
    </message>
    <message>
        <source>Standard input is no JSON object; give one such as {&quot;query&quot;: {&quot;patient_id&quot;: …}}.</source>
        <translation>Die Standardeingabe ist kein JSON-Objekt; geben Sie eines an wie {&quot;query&quot;: {&quot;patient_id&quot;: …}}.</translation>
    </message>
    <message>
        <source>Standard input has a field that is unknown or has a wrong value: &quot;%1&quot;; palpate-fetch&apos;s README lists them.</source>
        <translation>Die Standardeingabe hat ein unbekanntes Feld oder eines mit falschem Wert: „%1“; das README von palpate-fetch nennt die Felder.</translation>
    </message>
    <message>
        <source>The query is empty, and a search for everything is not made; give a patient, an accession number, a date or a description.</source>
        <translation>Die Suche ist leer, und nach allem wird nicht gesucht; geben Sie Patient, Accession-Nummer, Datum oder Beschreibung an.</translation>
    </message>
    <message>
        <source>Give the index of a series, as find lists them.</source>
        <translation>Geben Sie die Nummer einer Serie an, wie find sie auflistet.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an empty folder of yours; name a new one for the images.</source>
        <translation>„%1“ ist kein leerer Ordner, der Ihnen gehört; nennen Sie einen neuen für die Bilder.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no numeric address; give the one at which the server reaches this machine.</source>
        <translation>„%1“ ist keine numerische Adresse; geben Sie die an, unter der der Server diesen Rechner erreicht.</translation>
    </message>
    <message>
        <source>C-MOVE with TLS needs a certificate of this machine, since the server connects to it; give --certificate and --key.</source>
        <translation>C-MOVE mit TLS braucht ein Zertifikat dieses Rechners, da der Server sich mit ihm verbindet; geben Sie --certificate und --key an.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no certificate that can be read (PEM).</source>
        <translation>„%1“ ist kein lesbares Zertifikat (PEM).</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no private key that can be read (PEM), or its passphrase is another.</source>
        <translation>„%1“ ist kein lesbarer privater Schlüssel (PEM), oder seine Passphrase ist eine andere.</translation>
    </message>
    <message>
        <source>The desktop&apos;s keyring does not answer; unlock it, or log in with --login basic.</source>
        <translation>Der Schlüsselbund des Desktops antwortet nicht; entsperren Sie ihn, oder melden Sie sich mit --login basic an.</translation>
    </message>
    <message>
        <source>The keyring has no entry for %1; store one, or log in with --login basic.</source>
        <translation>Der Schlüsselbund hat keinen Eintrag für %1; legen Sie einen an, oder melden Sie sich mit --login basic an.</translation>
    </message>
    <message>
        <source>Stopped; nothing of the transfer was kept.</source>
        <translation>Angehalten; von der Übertragung wurde nichts behalten.</translation>
    </message>
    <message>
        <source>The transfer could not be started; close other programs and try again.</source>
        <translation>Die Übertragung ließ sich nicht starten; schließen Sie andere Programme und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The server&apos;s answer needs more memory than a transfer may take; search more narrowly.</source>
        <translation>Die Antwort des Servers braucht mehr Speicher, als eine Übertragung haben darf; suchen Sie enger.</translation>
    </message>
    <message>
        <source>The server was not done after %1 s, and the transfer was ended.</source>
        <translation>Der Server war nach %1 s nicht fertig, und die Übertragung wurde beendet.</translation>
    </message>
    <message>
        <source>The transfer ended by itself: what the server sent cannot be read, or needs more memory or time than allowed. Nothing was kept.</source>
        <translation>Die Übertragung endete von selbst: Was der Server sendete, ist nicht lesbar oder braucht mehr Speicher oder Zeit als erlaubt. Nichts wurde behalten.</translation>
    </message>
    <message>
        <source>The images cannot be written to &quot;%1&quot;; look whether the disk is full.</source>
        <translation>Die Bilder lassen sich nicht nach „%1“ schreiben; sehen Sie nach, ob der Datenträger voll ist.</translation>
    </message>
    <message>
        <source>The host of &quot;%1&quot; is not known; check its name.</source>
        <translation>Der Host von „%1“ ist nicht bekannt; prüfen Sie seinen Namen.</translation>
    </message>
    <message>
        <source>The host of &quot;%1&quot; does not answer; check its address, the network and the firewall.</source>
        <translation>Der Host von „%1“ antwortet nicht; prüfen Sie seine Adresse, das Netzwerk und die Firewall.</translation>
    </message>
    <message>
        <source>The host of &quot;%1&quot; refuses the connection: no server listens at this port; check the port.</source>
        <translation>Der Host von „%1“ lehnt die Verbindung ab: An diesem Port hört kein Server; prüfen Sie den Port.</translation>
    </message>
    <message>
        <source>What listens at &quot;%1&quot; does not answer as a web server does; check the port.</source>
        <translation>Was bei „%1“ hört, antwortet nicht wie ein Webserver; prüfen Sie den Port.</translation>
    </message>
    <message>
        <source>What listens at &quot;%1&quot; closed the connection without an answer; check the port, and whether the server wants TLS.</source>
        <translation>Was bei „%1“ hört, schloss die Verbindung ohne Antwort; prüfen Sie den Port, und ob der Server TLS verlangt.</translation>
    </message>
    <message>
        <source>TLS could not be set up with &quot;%1&quot;; check the port, and whether the server has TLS there.</source>
        <translation>Mit „%1“ ließ sich TLS nicht einrichten; prüfen Sie den Port, und ob der Server dort TLS hat.</translation>
    </message>
    <message>
        <source>TLS could not be set up on this machine; install Palpate again.</source>
        <translation>Auf diesem Rechner ließ sich TLS nicht einrichten; installieren Sie Palpate noch einmal.</translation>
    </message>
    <message>
        <source>The certificate of &quot;%1&quot; has expired or is not valid yet; check this machine&apos;s clock, and tell the server&apos;s administrator.</source>
        <translation>Das Zertifikat von „%1“ ist abgelaufen oder noch nicht gültig; prüfen Sie die Uhr dieses Rechners, und sagen Sie es dem Administrator des Servers.</translation>
    </message>
    <message>
        <source>The certificate of &quot;%1&quot; is for another host; check the host&apos;s name.</source>
        <translation>Das Zertifikat von „%1“ gilt für einen anderen Host; prüfen Sie den Namen des Hosts.</translation>
    </message>
    <message>
        <source>The certificate of &quot;%1&quot; is from an authority that this machine does not know; get the authority&apos;s certificate from the administrator and give it with --authority.</source>
        <translation>Das Zertifikat von „%1“ stammt von einer Zertifizierungsstelle, die dieser Rechner nicht kennt; lassen Sie sich deren Zertifikat vom Administrator geben, und geben Sie es mit --authority an.</translation>
    </message>
    <message>
        <source>The certificate of &quot;%1&quot; is not valid; tell the server&apos;s administrator.</source>
        <translation>Das Zertifikat von „%1“ ist nicht gültig; sagen Sie es dem Administrator des Servers.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; wants a certificate of this machine; give --certificate and --key.</source>
        <translation>„%1“ verlangt ein Zertifikat dieses Rechners; geben Sie --certificate und --key an.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; refuses this machine&apos;s certificate; ask the administrator for one that it trusts.</source>
        <translation>„%1“ lehnt das Zertifikat dieses Rechners ab; bitten Sie den Administrator um eines, dem der Server vertraut.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; sends this program to another host or in a circle, which is not followed; use the server&apos;s own URL.</source>
        <translation>„%1“ verweist dieses Programm an einen anderen Host oder im Kreis, und dem wird nicht gefolgt; verwenden Sie die eigene URL des Servers.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; wants a login; give one with --login.</source>
        <translation>„%1“ verlangt eine Anmeldung; geben Sie eine mit --login an.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; refuses the login; check user and password, or the token.</source>
        <translation>„%1“ lehnt die Anmeldung ab; prüfen Sie Benutzer und Passwort oder das Token.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not permit this; ask its administrator for permission to search and retrieve.</source>
        <translation>„%1“ erlaubt dies nicht; bitten Sie den Administrator um die Erlaubnis, zu suchen und abzurufen.</translation>
    </message>
    <message>
        <source>There is no DICOMweb at &quot;%1&quot;; check the path of the URL, such as /dicom-web.</source>
        <translation>Bei „%1“ gibt es kein DICOMweb; prüfen Sie den Pfad der URL, etwa /dicom-web.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not have the AE title &quot;%2&quot;; ask its administrator for the server&apos;s title.</source>
        <translation>„%1“ hat nicht den AE-Titel „%2“; fragen Sie den Administrator nach dem Titel des Servers.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not know this program&apos;s AE title &quot;%2&quot;; ask its administrator to add it, or give one that it knows with --calling.</source>
        <translation>„%1“ kennt den AE-Titel „%2“ dieses Programms nicht; bitten Sie den Administrator, ihn einzutragen, oder geben Sie mit --calling einen an, den der Server kennt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; rejects the association from &quot;%3&quot; to &quot;%2&quot; without a reason; ask its administrator whether both AE titles are known to it.</source>
        <translation>„%1“ weist die Assoziation von „%3“ zu „%2“ ohne Grund ab; fragen Sie den Administrator, ob der Server beide AE-Titel kennt.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes no more associations for now; try again later.</source>
        <translation>„%1“ nimmt vorerst keine Assoziationen mehr an; versuchen Sie es später noch einmal.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; ended the association at the first request: it does not know &quot;%2&quot; or does not permit it to search; ask its administrator.</source>
        <translation>„%1“ beendete die Assoziation bei der ersten Anfrage: Der Server kennt „%2“ nicht oder erlaubt ihm keine Suche; fragen Sie den Administrator.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; offers no C-GET to this program; ask its administrator for permission, or switch C-MOVE on for it.</source>
        <translation>„%1“ bietet diesem Programm kein C-GET an; bitten Sie den Administrator um Erlaubnis, oder schalten Sie C-MOVE ein.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; offers no C-MOVE to this program; ask its administrator for permission.</source>
        <translation>„%1“ bietet diesem Programm kein C-MOVE an; bitten Sie den Administrator um Erlaubnis.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not know where to send images for &quot;%2&quot;; ask its administrator to enter this program&apos;s AE title with its address and port.</source>
        <translation>„%1“ weiß nicht, wohin Bilder für „%2“ zu senden sind; bitten Sie den Administrator, den AE-Titel dieses Programms mit Adresse und Port einzutragen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be listened on: %2; give an address of this machine and a port that is free.</source>
        <translation>An „%1“ lässt sich nicht hören: %2; geben Sie eine Adresse dieses Rechners und einen freien Port an.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; answers, and lets this program search.</source>
        <translation>„%1“ antwortet und lässt dieses Programm suchen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was silent for %2 s, and the transfer was ended; try again later.</source>
        <translation>„%1“ schwieg %2 s lang, und die Übertragung wurde beendet; versuchen Sie es später noch einmal.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; sends less than %2 bytes a second, and the transfer was ended; try again later.</source>
        <translation>„%1“ sendet weniger als %2 Bytes in der Sekunde, und die Übertragung wurde beendet; versuchen Sie es später noch einmal.</translation>
    </message>
    <message>
        <source>The connection to &quot;%1&quot; was lost; try again.</source>
        <translation>Die Verbindung zu „%1“ ging verloren; versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The server&apos;s answer was cut off; try again.</source>
        <translation>Die Antwort des Servers brach ab; versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The server&apos;s answer is too long; search more narrowly.</source>
        <translation>Die Antwort des Servers ist zu lang; suchen Sie enger.</translation>
    </message>
    <message>
        <source>More than %1 entries match; search more narrowly.</source>
        <translation>Mehr als %1 Einträge passen; suchen Sie enger.</translation>
    </message>
    <message>
        <source>%1 entries have no identifier as DICOM has them, and were left out.</source>
        <translation>%1 Einträge haben keine Kennung, wie DICOM sie hat, und wurden weggelassen.</translation>
    </message>
    <message>
        <source>There is no series %1: %2 match.</source>
        <translation>Es gibt keine Serie %1: %2 passen.</translation>
    </message>
    <message>
        <source>The server&apos;s list has changed, and the index names another series now; search again.</source>
        <translation>Die Liste des Servers hat sich geändert, und die Nummer nennt jetzt eine andere Serie; suchen Sie noch einmal.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; answered with something else than images; ask its administrator.</source>
        <translation>„%1“ antwortete mit etwas anderem als Bildern; fragen Sie den Administrator.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; sent images of another series than was asked for, and none of them was kept.</source>
        <translation>„%1“ sendete Bilder einer anderen Serie als der gewünschten, und keines davon wurde behalten.</translation>
    </message>
    <message>
        <source>The server sent more than %1 files that were not asked for, and the transfer was ended.</source>
        <translation>Der Server sendete mehr als %1 Dateien, um die nicht gebeten wurde, und die Übertragung wurde beendet.</translation>
    </message>
    <message>
        <source>%1 images of other series were sent although they were not asked for, and were not kept.</source>
        <translation>%1 Bilder anderer Serien wurden gesendet, obwohl um sie nicht gebeten wurde, und nicht behalten.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; sent files that are not DICOM, and none of them was kept.</source>
        <translation>„%1“ sendete Dateien, die kein DICOM sind, und keine davon wurde behalten.</translation>
    </message>
    <message>
        <source>%1 files that are not DICOM were sent, and were not kept.</source>
        <translation>%1 Dateien, die kein DICOM sind, wurden gesendet und nicht behalten.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; sent no image of the series; ask its administrator for permission to retrieve.</source>
        <translation>„%1“ sendete kein Bild der Serie; bitten Sie den Administrator um die Erlaubnis, Bilder abzurufen.</translation>
    </message>
    <message>
        <source>%1 images that the server lists did not come.</source>
        <translation>%1 Bilder, die der Server auflistet, kamen nicht.</translation>
    </message>
    <message>
        <source>The series has more than %1 images, and none was kept.</source>
        <translation>Die Serie hat mehr als %1 Bilder, und keines wurde behalten.</translation>
    </message>
    <message>
        <source>The series is larger than %1 GiB, and none of it was kept.</source>
        <translation>Die Serie ist größer als %1 GiB, und nichts davon wurde behalten.</translation>
    </message>
    <message>
        <source>its %1 has %2 components, not one</source>
        <translation>sein %1 hat %2 Komponenten und nicht eine</translation>
    </message>
    <message>
        <source>its %1 has %2 pixels and the header says %3</source>
        <translation>sein %1 hat %2 Pixel, und der Kopf nennt %3</translation>
    </message>
    <message>
        <source>its %1 has values of %2 bits and the header says %3 of %4</source>
        <translation>sein %1 hat Werte von %2 Bit, und der Kopf nennt %3 von %4</translation>
    </message>
    <message>
        <source>it is coded by another JPEG process than its transfer syntax names</source>
        <translation>es ist durch ein anderes JPEG-Verfahren codiert, als seine Transfersyntax nennt</translation>
    </message>
    <message>
        <source>it is coded with loss and its transfer syntax is lossless</source>
        <translation>es ist mit Verlust codiert, und seine Transfersyntax ist verlustfrei</translation>
    </message>
    <message>
        <source>its JPEG 2000 image and the header differ on whether values have a sign</source>
        <translation>sein JPEG-2000-Bild und der Kopf sind sich nicht einig, ob Werte ein Vorzeichen haben</translation>
    </message>
    <message>
        <source>its RLE table has %1 segments where %2 bits need %3</source>
        <translation>seine RLE-Tabelle hat %1 Segmente, wo %2 Bit %3 brauchen</translation>
    </message>
    <message>
        <source>it has %1 pixels, more than any slice does</source>
        <translation>es hat %1 Pixel, mehr als jede Schicht hat</translation>
    </message>
    <message>
        <source>Compressed images are decoded by the program %1, which is not installed; install Palpate again, or export the images as explicit little endian.</source>
        <translation>Komprimierte Bilder decodiert das Programm %1, das nicht installiert ist; installieren Sie Palpate noch einmal, oder exportieren Sie die Bilder als Explicit Little Endian.</translation>
    </message>
    <message>
        <source>The file %1 states a %2 that is not written as DICOM writes numbers (&quot;1.5&quot;, with a point and without a unit), or too many or too few of them; export it again.</source>
        <translation>Die Datei %1 nennt %2 nicht so, wie DICOM Zahlen schreibt („1.5“, mit einem Punkt und ohne Einheit), oder mit zu vielen oder zu wenigen Zahlen; exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>The file %1 was copied as if it were text, which put bytes among its pixels; copy it again in binary mode.</source>
        <translation>Die Datei %1 wurde kopiert, als wäre sie Text, wodurch Bytes zwischen ihre Pixel gerieten; kopieren Sie sie noch einmal, im Binärmodus.</translation>
    </message>
    <message>
        <source>A file of the series describes an image and ends without its pixels; fetch it again.</source>
        <translation>Eine Datei der Serie beschreibt ein Bild und endet ohne seine Pixel; holen Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>The series holds colour pictures, which have no isosurface; choose the series of the scan.</source>
        <translation>Die Serie enthält Farbbilder, und diese haben keine Isofläche; wählen Sie die Serie der Aufnahme.</translation>
    </message>
    <message>
        <source>A file of the series holds more pixels than the slices it states; export it again, as one file per slice.</source>
        <translation>Eine Datei der Serie enthält mehr Pixel als die Schichten, die sie nennt; exportieren Sie sie noch einmal, mit einer Datei für jede Schicht.</translation>
    </message>
    <message>
        <source>The series is a scout view for planning and no stack of slices; choose the series of the scan.</source>
        <translation>Die Serie ist eine Übersichtsaufnahme (Topogramm) zur Planung und kein Schichtstapel; wählen Sie die Serie der Aufnahme.</translation>
    </message>
    <message>
        <source>The pixels of %1 are stored in another way than its transfer syntax says; export it again.</source>
        <translation>Die Pixel von %1 sind anders gespeichert, als die Transfersyntax sagt; exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>A file of the series states %1 x %2 pixels of %3 bits, which is not an image that can be read.</source>
        <translation>Eine Datei der Serie nennt %1 x %2 Pixel von %3 Bit, und das ist kein lesbares Bild.</translation>
    </message>
    <message>
        <source>The series does not say where its slices lie (position, orientation or pixel spacing is missing); export it again with its geometry.</source>
        <translation>Die Serie sagt nicht, wo ihre Schichten liegen (Position, Ausrichtung oder Pixelabstand fehlt); exportieren Sie sie noch einmal mit ihrer Geometrie.</translation>
    </message>
    <message>
        <source>The file %1 maps its stored values through a table (Modality LUT), which is not done here; export it with a rescale slope and intercept.</source>
        <translation>Die Datei %1 bildet ihre gespeicherten Werte durch eine Tabelle ab (Modality LUT), was hier nicht gemacht wird; exportieren Sie sie mit Rescale Slope und Rescale Intercept.</translation>
    </message>
    <message>
        <source>The file %1 does not say whether its pixels have a sign (Pixel Representation); export it again.</source>
        <translation>Die Datei %1 sagt nicht, ob ihre Pixel ein Vorzeichen haben (Pixel Representation); exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>The header of %1 cannot be understood; export it again.</source>
        <translation>Der Kopf von %1 ist nicht zu verstehen; exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>%(1) (%2 of %3 files).</source>
        <translation>%(1) (%2 von %3 Dateien).</translation>
    </message>
    <message>
        <source>The series holds several acquisitions whose slices lie between each other&apos;s, and it cannot be told which belong together; put each acquisition into a folder of its own.</source>
        <translation>Die Serie enthält mehrere Akquisitionen, deren Schichten zwischeneinander liegen, und es ist nicht zu erkennen, welche zusammengehören; legen Sie jede Akquisition in einen eigenen Ordner.</translation>
    </message>
    <message>
        <source>%1 is no DICOM file, or not any more; open the folder of one series.</source>
        <translation>%1 ist keine DICOM-Datei oder keine mehr; öffnen Sie den Ordner einer Serie.</translation>
    </message>
    <message>
        <source>%1 holds no image: it is the index of a folder, or no DICOM after all; open the folder of one series.</source>
        <translation>%1 enthält kein Bild: Es ist das Verzeichnis eines Ordners oder doch kein DICOM; öffnen Sie den Ordner einer Serie.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The largest part without a gap has %1 of the %2 slices that are there, from %3 to %4 mm along the stack.</source>
        <translation>Der größte Teil ohne Lücke hat %1 der %2 vorhandenen Schichten, von %3 bis %4 mm entlang des Stapels.</translation>
    </message>
    <message>
        <source>One evenly spaced stack of %1 slices.</source>
        <translation>Ein gleichmäßiger Stapel von %1 Schichten.</translation>
    </message>
    <message>
        <source>A single slice, taken to be as thick as it states.</source>
        <translation>Eine einzelne Schicht, so dick angenommen, wie sie angibt.</translation>
    </message>
    <message>
        <source>The pixels of %1 cannot be decoded: they are cut off, damaged or in a form unknown here; fetch the file again or export it as explicit little endian.</source>
        <translation>Die Pixel von %1 lassen sich nicht decodieren: Sie sind abgeschnitten, beschädigt oder in einer hier unbekannten Form; holen Sie die Datei noch einmal, oder exportieren Sie sie als Explicit Little Endian.</translation>
    </message>
    <message>
        <source>The compressed image in %1 cannot be shown: %2; fetch the file again or export it as explicit little endian.</source>
        <translation>Das komprimierte Bild in %1 lässt sich nicht zeigen: %2; holen Sie die Datei noch einmal, oder exportieren Sie sie als Explicit Little Endian.</translation>
    </message>
    <message>
        <source>The compressed image in %1 is damaged in a way that its decoder does not bear; fetch the file again or export it as explicit little endian.</source>
        <translation>Das komprimierte Bild in %1 ist so beschädigt, dass sein Decoder es nicht verträgt; holen Sie die Datei noch einmal, oder exportieren Sie sie als Explicit Little Endian.</translation>
    </message>
    <message>
        <source>A series that is to be resampled is read whole or not at all; free memory by closing other programs.</source>
        <translation>Eine Serie, die umgerechnet werden soll, wird ganz gelesen oder gar nicht; schaffen Sie Speicher, indem Sie andere Programme schließen.</translation>
    </message>
    <message>
        <source>The series&apos; rescaled values fit no voxel type; export it again.</source>
        <translation>Die umgerechneten Werte der Serie passen in keine Art von Voxeln; exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>%1 is or inflates to more than a scan&apos;s file should; export it uncompressed.</source>
        <translation>%1 ist größer oder wird entpackt größer, als die Datei einer Aufnahme sein sollte; exportieren Sie sie unkomprimiert.</translation>
    </message>
    <message>
        <source>%1 cannot be read; copy or fetch it again.</source>
        <translation>%1 lässt sich nicht lesen; kopieren oder holen Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>The series mixes slices of %1 x %2 and %3 x %4 pixels; put them into folders of their own.</source>
        <translation>Die Serie mischt Schichten von %1 x %2 und %3 x %4 Pixeln; legen Sie jede Größe in einen eigenen Ordner.</translation>
    </message>
    <message>
        <source>The series mixes slices that are turned against each other by up to %1 degrees; put each orientation into a folder of its own.</source>
        <translation>Die Serie mischt Schichten, die um bis zu %1 Grad gegeneinander gedreht sind; legen Sie jede Ausrichtung in einen eigenen Ordner.</translation>
    </message>
    <message>
        <source>The series mixes pixel spacings of %1 and %2 mm; put them into folders of their own.</source>
        <translation>Die Serie mischt Pixelabstände von %1 und %2 mm; legen Sie jeden in einen eigenen Ordner.</translation>
    </message>
    <message>
        <source>%1 of %2 slices lie at the position of another one; keep one image of each position in the folder.</source>
        <translation>%1 von %2 Schichten liegen an der Position einer anderen; behalten Sie von jeder Position ein Bild im Ordner.</translation>
    </message>
    <message>
        <source>The slices advance %1 degrees off the direction that they face, which no gantry does; export the series again.</source>
        <translation>Die Schichten rücken um %1 Grad neben der Richtung vor, in die sie zeigen, was keine Gantry tut; exportieren Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>A slice of the series lies %1 mm beside the others; ask for a reconstruction as one straight stack.</source>
        <translation>Eine Schicht der Serie liegt %1 mm neben den anderen; bitten Sie um eine Rekonstruktion als gerader Stapel.</translation>
    </message>
    <message>
        <source>1 slice is missing from the series (%1 of %2 steps are a multiple of %3 mm); fetch the series again.</source>
        <translation>1 Schicht fehlt in der Serie (%1 von %2 Abständen sind ein Vielfaches von %3 mm); holen Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>%1 slices are missing from the series (%2 of %3 steps are a multiple of %4 mm); fetch the series again.</source>
        <translation>%1 Schichten fehlen in der Serie (%2 von %3 Abständen sind ein Vielfaches von %4 mm); holen Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced: %1 of %2 steps differ from %3 mm, from %4 to %5 mm.</source>
        <translation>Die Schichten haben ungleiche Abstände: %1 von %2 Abständen weichen von %3 mm ab, von %4 bis %5 mm.</translation>
    </message>
    <message>
        <source>The slices are tilted by %1 degrees against the direction in which they advance.</source>
        <translation>Die Schichten sind um %1 Grad gegen die Richtung gekippt, in der sie vorrücken.</translation>
    </message>
    <message>
        <source>The slices are tilted by %1 degrees against the direction in which they advance, and unevenly spaced.</source>
        <translation>Die Schichten sind um %1 Grad gegen die Richtung gekippt, in der sie vorrücken, und haben ungleiche Abstände.</translation>
    </message>
    <message>
        <source>%(1); there are too few of them to fill the gaps, so ask for a reconstruction with even spacing.</source>
        <translation>%(1); es sind zu wenige, um die Lücken zu füllen, also bitten Sie um eine Rekonstruktion mit gleichen Abständen.</translation>
    </message>
    <message>
        <source>%(1), and lie %2 pixels beside each other, which no scan does; export it again.</source>
        <translation>%(1) und liegen %2 Pixel nebeneinander, was keine Aufnahme tut; exportieren Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>%(1); they can be resampled onto a right-angled grid of even steps.</source>
        <translation>%(1); sie lassen sich auf ein rechtwinkliges Gitter mit gleichen Abständen umrechnen.</translation>
    </message>
    <message>
        <source>The archive %1 holds more than a study, or more than the disk for temporary files has room for; unpack it yourself and open the folder of one series.</source>
        <translation>Das Archiv %1 enthält mehr als eine Studie oder mehr, als der Datenträger für temporäre Dateien fasst; entpacken Sie es selbst, und öffnen Sie den Ordner einer Serie.</translation>
    </message>
    <message>
        <source>The archive %1 is locked with a password; unpack it yourself and open the folder.</source>
        <translation>Das Archiv %1 ist mit einem Passwort verschlossen; entpacken Sie es selbst, und öffnen Sie den Ordner.</translation>
    </message>
    <message>
        <source>The archive %1 holds a name that leads out of it or too deep into it; unpack it yourself and open the folder.</source>
        <translation>Das Archiv %1 enthält einen Namen, der aus ihm hinaus oder zu tief hinein führt; entpacken Sie es selbst, und öffnen Sie den Ordner.</translation>
    </message>
    <message>
        <source>The folder for temporary files, &quot;%1&quot;, cannot be written, and an archive is unpacked there; set TMPDIR to one that can be, or unpack the archive yourself.</source>
        <translation>Der Ordner für temporäre Dateien, „%1“, ist nicht beschreibbar, und dort wird ein Archiv entpackt; setzen Sie TMPDIR auf einen beschreibbaren, oder entpacken Sie das Archiv selbst.</translation>
    </message>
    <message>
        <source>The header %1 names a data file outside its own folder; put both into one folder and name it without a path.</source>
        <translation>Der Kopf %1 nennt eine Datendatei außerhalb seines Ordners; legen Sie beide in einen Ordner, und nennen Sie sie ohne Pfad.</translation>
    </message>
    <message>
        <source>The volume has an axis without voxels; its header is broken.</source>
        <translation>Das Volumen hat eine Achse ohne Voxel; sein Kopf ist fehlerhaft.</translation>
    </message>
    <message>
        <source>The volume&apos;s voxel spacing of %1 x %2 x %3 mm cannot be right; export it again with its geometry.</source>
        <translation>Der Voxelabstand des Volumens von %1 x %2 x %3 mm kann nicht stimmen; exportieren Sie es noch einmal mit seiner Geometrie.</translation>
    </message>
    <message>
        <source>The volume is said to lie %1 m away from the origin of its space, which cannot be right; export it again with its geometry.</source>
        <translation>Das Volumen soll %1 m vom Ursprung seines Raumes entfernt liegen, was nicht stimmen kann; exportieren Sie es noch einmal mit seiner Geometrie.</translation>
    </message>
    <message>
        <source>The volume&apos;s axes are %1 degrees off their right angles; resample it onto a right-angled grid first.</source>
        <translation>Die Achsen des Volumens weichen um %1 Grad vom rechten Winkel ab; rechnen Sie es zuerst auf ein rechtwinkliges Gitter um.</translation>
    </message>
    <message>
        <source>The folder %1 holds more than %2 files; open the folder of one study.</source>
        <translation>Der Ordner %1 enthält mehr als %2 Dateien; öffnen Sie den Ordner einer Studie.</translation>
    </message>
    <message>
        <source>%1 cannot be opened without loading it whole; copy it to a disk of this machine, or read a part of it.</source>
        <translation>%1 lässt sich nicht öffnen, ohne alles zu laden; kopieren Sie die Datei auf einen Datenträger dieses Rechners, oder lesen Sie einen Teil davon.</translation>
    </message>
    <message>
        <source>Every %1th voxel is none; take every second, say.</source>
        <translation>Jedes %1. Voxel ist keines; nehmen Sie zum Beispiel jedes zweite.</translation>
    </message>
    <message>
        <source>The box from %1 to %2 lies outside an axis of %3 voxels; choose one inside.</source>
        <translation>Die Box von %1 bis %2 liegt außerhalb einer Achse von %3 Voxeln; wählen Sie eine innerhalb.</translation>
    </message>
    <message>
        <source>There is no file or folder %1 that can be read; check its name and its permissions.</source>
        <translation>Es gibt keine lesbare Datei und keinen lesbaren Ordner %1; prüfen Sie Namen und Zugriffsrechte.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>close other programs</source>
        <translation>schließen Sie andere Programme</translation>
    </message>
    <message>
        <source>The volume needs %1 GB of memory and %2 GB are free; read every second voxel or a box of it, or %3.</source>
        <translation>Das Volumen braucht %1 GB Speicher, und %2 GB sind frei; lesen Sie jedes zweite Voxel oder eine Box davon, oder %3.</translation>
    </message>
    <message>
        <source>save it raw with a detached header</source>
        <translation>speichern Sie es roh mit getrenntem Kopf</translation>
    </message>
    <message>
        <source>save it with numbers in every voxel</source>
        <translation>speichern Sie es mit Zahlen in jedem Voxel</translation>
    </message>
    <message>
        <source>The header of %1 states more voxels than any memory holds; export it again.</source>
        <translation>Der Kopf von %1 nennt mehr Voxel, als jeder Speicher fasst; exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>%1 holds %2 volumes; export fewer than %3 into one file.</source>
        <translation>%1 enthält %2 Volumen; exportieren Sie weniger als %3 in eine Datei.</translation>
    </message>
    <message>
        <source>%1 is too short for the voxels that its header states; copy or fetch it again.</source>
        <translation>%1 ist zu kurz für die Voxel, die der Kopf nennt; kopieren oder holen Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>%1 is not a mesh that can be read; save the tool as STL, OBJ or PLY.</source>
        <translation>%1 ist kein lesbares Gitternetz; speichern Sie das Werkzeug als STL, OBJ oder PLY.</translation>
    </message>
    <message>
        <source>%1 is larger than 1 GB; reduce the mesh first.</source>
        <translation>%1 ist größer als 1 GB; verkleinern Sie zuerst das Gitternetz.</translation>
    </message>
    <message>
        <source>%1 holds no triangle; a tool needs a surface, so export one.</source>
        <translation>%1 enthält kein Dreieck; ein Werkzeug braucht eine Oberfläche, also exportieren Sie eine.</translation>
    </message>
    <message>
        <source>The mesh is open (%1 edges have one triangle); it is touched with its vertices all the same.</source>
        <translation>Das Gitternetz ist offen (%1 Kanten haben nur ein Dreieck); es wird trotzdem mit seinen Eckpunkten abgetastet.</translation>
    </message>
    <message>
        <source>The mesh is not manifold (%1 edges have more than two triangles); it is touched with its vertices all the same.</source>
        <translation>Das Gitternetz ist keine Mannigfaltigkeit (%1 Kanten haben mehr als zwei Dreiecke); es wird trotzdem mit seinen Eckpunkten abgetastet.</translation>
    </message>
    <message>
        <source>The tool is %1 mm long, which is unusual; check the unit of the mesh.</source>
        <translation>Das Werkzeug ist %1 mm lang, was ungewöhnlich ist; prüfen Sie die Einheit des Gitternetzes.</translation>
    </message>
    <message>
        <source>%1 has %2 axes; export a volume of three.</source>
        <translation>%1 hat %2 Achsen; exportieren Sie ein Volumen mit drei.</translation>
    </message>
    <message>
        <source>The voxels of %1 are spread over several files; save them as one.</source>
        <translation>Die Voxel von %1 sind auf mehrere Dateien verteilt; speichern Sie sie als eine.</translation>
    </message>
    <message>
        <source>The header of %1 says nothing of the %2 bytes that its data file holds beside the voxels; export it again.</source>
        <translation>Der Kopf von %1 sagt nichts über die %2 Bytes, die die Datendatei neben den Voxeln enthält; exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>The voxels of %1 are of a type that cannot be shown or touched exactly; convert them to 32-bit integers or float.</source>
        <translation>Die Voxel von %1 sind von einer Art, die sich nicht genau zeigen oder tasten lässt; wandeln Sie sie in ganze Zahlen mit 32 Bit oder in Gleitkommazahlen um.</translation>
    </message>
    <message>
        <source>The header of %1 places the voxels twice, by its qform and by its sform, and not alike; export it with one of them.</source>
        <translation>Der Kopf von %1 legt die Voxel zweimal fest, durch qform und durch sform, und nicht gleich; exportieren Sie die Datei mit einem davon.</translation>
    </message>
    <message>
        <source>The header of %1 calls %2 of its four axes places, by direction or by kind; export it with three of them and one that counts volumes.</source>
        <translation>Der Kopf von %1 nennt %2 seiner vier Achsen Orte, nach Richtung oder Art; exportieren Sie die Datei mit dreien davon und einer, die Volumen zählt.</translation>
    </message>
    <message>
        <source>The voxels of %1 are in an encoding that is unknown here; save them as raw or gzip.</source>
        <translation>Die Voxel von %1 sind in einer Codierung, die hier unbekannt ist; speichern Sie sie als raw oder gzip.</translation>
    </message>
    <message>
        <source>%1 is no NRRD file: it does not begin with NRRD0001 to NRRD0005. Open the file itself, or export it again.</source>
        <translation>%1 ist keine NRRD-Datei: Sie beginnt nicht mit NRRD0001 bis NRRD0005. Öffnen Sie die Datei selbst, oder exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>The header of %1 states spacings that do not lead from its axis mins to its axis maxs; export it again with its geometry.</source>
        <translation>Der Kopf von %1 nennt Abstände, die nicht von „axis mins“ zu „axis maxs“ führen; exportieren Sie die Datei noch einmal mit ihrer Geometrie.</translation>
    </message>
    <message>
        <source>Voxel %1 of %2 is written as something that is no value of its type; export it again as raw.</source>
        <translation>Voxel %1 von %2 ist als etwas geschrieben, das kein Wert seiner Art ist; exportieren Sie die Datei noch einmal als raw.</translation>
    </message>
    <message>
        <source>One evenly spaced stack.</source>
        <translation>Ein gleichmäßiger Stapel.</translation>
    </message>
    <message>
        <source>The file does not state its orientation: left and right are unknown, and its spacing is taken to be in millimetres.</source>
        <translation>Die Datei nennt ihre Ausrichtung nicht: Links und rechts sind unbekannt, und ihr Abstand wird in Millimetern verstanden.</translation>
    </message>
    <message>
        <source>The file states neither orientation nor spacing: left and right are unknown, and voxels of 1 mm are assumed.</source>
        <translation>Die Datei nennt weder Ausrichtung noch Abstand: Links und rechts sind unbekannt, und Voxel von 1 mm werden angenommen.</translation>
    </message>
    <message>
        <source>The file states no spacing: voxels of 1 mm are assumed.</source>
        <translation>Die Datei nennt keinen Abstand: Voxel von 1 mm werden angenommen.</translation>
    </message>
    <message>
        <source>%1 is %2, %3, %4 mm</source>
        <translation>%1 ist %2, %3, %4 mm</translation>
    </message>
    <message>
        <source>%1 is %2, %3, %4 mm, correctable (%5)</source>
        <translation>%1 ist %2, %3, %4 mm, korrigierbar (%5)</translation>
    </message>
    <message>
        <source>%1 is %2, %3, refused (%4)</source>
        <translation>%1 ist %2, %3, abgelehnt (%4)</translation>
    </message>
    <message>
        <source>of no modality</source>
        <translation>ohne Modalität</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>%1; and %2 more</source>
        <translation>%1; und %2 weitere</translation>
    </message>
    <message>
        <source>%1 has no series %2: %3.</source>
        <translation>%1 hat keine Serie %2: %3.</translation>
    </message>
    <message>
        <source>%1 holds %2 series that can be loaded; name one: %3.</source>
        <translation>%1 enthält %2 Serien, die sich laden lassen; nennen Sie eine: %3.</translation>
    </message>
    <message>
        <source>None of the %1 series in %2 can be loaded; the first: %3</source>
        <translation>Keine der %1 Serien in %2 lässt sich laden; die erste: %3</translation>
    </message>
    <message>
        <source>The folder holds more volumes than can be listed; open this file by itself.</source>
        <translation>Der Ordner enthält mehr Volumen, als sich auflisten lassen; öffnen Sie diese Datei für sich.</translation>
    </message>
    <message>
        <source>%1 may not be read by this user; change its permissions or copy it.</source>
        <translation>%1 darf von diesem Benutzer nicht gelesen werden; ändern Sie die Zugriffsrechte, oder machen Sie eine Kopie.</translation>
    </message>
    <message>
        <source>%1 is no DICOM, NRRD, MetaImage or NIfTI file; open the folder of a DICOM series, one of its files, or an .nrrd, .nhdr, .mhd, .mha, .nii or .nii.gz file.</source>
        <translation>%1 ist keine Datei von DICOM, NRRD, MetaImage oder NIfTI; öffnen Sie den Ordner einer DICOM-Serie, eine ihrer Dateien oder eine Datei .nrrd, .nhdr, .mhd, .mha, .nii oder .nii.gz.</translation>
    </message>
    <message>
        <source>The recording could not be finished: %1. It stays &quot;%2&quot; and can be recovered once there is room.</source>
        <translation>Die Aufzeichnung ließ sich nicht abschließen: %1. Sie bleibt „%2“ und lässt sich wiederherstellen, sobald Platz ist.</translation>
    </message>
    <message>
        <source>The recording could not be finished: the file is damaged. It stays &quot;%1&quot;; look at the disk.</source>
        <translation>Die Aufzeichnung ließ sich nicht abschließen: Die Datei ist beschädigt. Sie bleibt „%1“; sehen Sie nach dem Datenträger.</translation>
    </message>
    <message>
        <source>Nothing was recorded: no tick came meanwhile.</source>
        <translation>Nichts wurde aufgezeichnet: Inzwischen kam kein Takt.</translation>
    </message>
    <message>
        <source>there is no memory left</source>
        <translation>es ist kein Speicher mehr frei</translation>
    </message>
    <message>
        <source>The recording stopped, and touch goes on: %1. Nothing was recorded until then.</source>
        <translation>Die Aufzeichnung endete, das Abtasten geht weiter: %1. Bis dahin wurde nichts aufgezeichnet.</translation>
    </message>
    <message>
        <source>The recording stopped, and touch goes on: %1. What was recorded until then is in &quot;%2&quot; and can be recovered.</source>
        <translation>Die Aufzeichnung endete, das Abtasten geht weiter: %1. Was bis dahin aufgezeichnet wurde, ist in „%2“ und lässt sich wiederherstellen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is what an earlier recording left; recover it with palpate-cli recover, or remove it.</source>
        <translation>„%1“ ist der Rest einer früheren Aufzeichnung; stellen Sie sie mit palpate-cli recover wieder her, oder entfernen Sie sie.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be recovered: %2.</source>
        <translation>„%1“ lässt sich nicht wiederherstellen: %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be recovered: there is no such file.</source>
        <translation>„%1“ lässt sich nicht wiederherstellen: Es gibt diese Datei nicht.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be recovered: it is being written.</source>
        <translation>„%1“ lässt sich nicht wiederherstellen: Die Datei wird gerade geschrieben.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be recovered: nothing was recorded yet; remove it.</source>
        <translation>„%1“ lässt sich nicht wiederherstellen: Noch wurde nichts aufgezeichnet; entfernen Sie die Datei.</translation>
    </message>
    <message>
        <source>The recording is damaged and cannot be read; use a copy of it.</source>
        <translation>Die Aufzeichnung ist beschädigt und lässt sich nicht lesen; verwenden Sie eine Kopie davon.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds no step; nothing was recorded.</source>
        <translation>„%1“ enthält keinen Schritt; nichts wurde aufgezeichnet.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was never finished; palpate-cli recover brings back what is in it.</source>
        <translation>„%1“ wurde nie abgeschlossen; palpate-cli recover holt zurück, was darin ist.</translation>
    </message>
    <message>
        <source>What was taken away from the scan in the recording comes out otherwise here: the scan or this version of Palpate is another; replay with the version that recorded it.</source>
        <translation>Was in der Aufzeichnung von der Aufnahme weggenommen wurde, fällt hier anders aus: Die Aufnahme oder diese Version von Palpate ist eine andere; spielen Sie sie mit der Version ab, die aufgezeichnet hat.</translation>
    </message>
    <message>
        <source>The key of this installation, &quot;%1&quot;, cannot be used (%2); volumes of recordings are not recognised until it can.</source>
        <translation>Der Schlüssel dieser Installation, „%1“, ist nicht verwendbar (%2); bis dahin werden die Volumen von Aufzeichnungen nicht wiedererkannt.</translation>
    </message>
    <message>
        <source>The key of this installation, &quot;%1&quot;, is damaged; put it back from a copy. Or remove it, for a new one: then no volume of an earlier recording is recognised any more.</source>
        <translation>Der Schlüssel dieser Installation, „%1“, ist beschädigt; holen Sie ihn aus einer Kopie zurück. Oder entfernen Sie ihn, damit ein neuer entsteht: Dann wird kein Volumen einer früheren Aufzeichnung mehr wiedererkannt.</translation>
    </message>
    <message>
        <source>The volume needs %1 MB of memory, which this machine does not give; try a smaller series or close other programs.</source>
        <translation>Das Volumen braucht %1 MB Speicher, den dieser Rechner nicht hergibt; versuchen Sie eine kleinere Serie, oder schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>The volume&apos;s axes are not at right angles; only right-angled stacks can be loaded.</source>
        <translation>Die Achsen des Volumens stehen nicht im rechten Winkel; laden lassen sich nur rechtwinklige Stapel.</translation>
    </message>
    <message>
        <source>The volume holds no finite voxel; there is nothing to see or touch.</source>
        <translation>Das Volumen enthält kein endliches Voxel; es gibt nichts zu sehen oder zu tasten.</translation>
    </message>
    <message>
        <source>What was taken away from the scan is stored in a way that cannot be read.</source>
        <translation>Was von der Aufnahme weggenommen wurde, ist nicht lesbar gespeichert.</translation>
    </message>
    <message>
        <source>The edit was cancelled; the scan is as it was.</source>
        <translation>Die Bearbeitung wurde abgebrochen; die Aufnahme ist, wie sie war.</translation>
    </message>
    <message>
        <source>The edit would take nothing away; choose another place or isovalue.</source>
        <translation>Die Bearbeitung nähme nichts weg; wählen Sie eine andere Stelle oder einen anderen Isowert.</translation>
    </message>
    <message>
        <source>There is no solid at the place; point at the surface, or lower the isovalue.</source>
        <translation>An der Stelle ist nichts Festes; zeigen Sie auf die Oberfläche, oder senken Sie den Isowert.</translation>
    </message>
    <message>
        <source>The crop box reaches beyond the scan; draw it within.</source>
        <translation>Die Zuschneidebox reicht über die Aufnahme hinaus; ziehen Sie sie innerhalb auf.</translation>
    </message>
    <message>
        <source>The scan&apos;s voxels cannot be edited in memory; load the scan again from its file.</source>
        <translation>Die Voxel der Aufnahme lassen sich im Speicher nicht bearbeiten; laden Sie die Aufnahme noch einmal aus der Datei.</translation>
    </message>
    <message>
        <source>There is too little memory for the edit, and the scan is as it was; close other programs.</source>
        <translation>Für die Bearbeitung ist zu wenig Speicher frei, und die Aufnahme ist, wie sie war; schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>The scan has %1 edits, and no more are kept; reset some first.</source>
        <translation>Die Aufnahme hat %1 Bearbeitungen, und mehr werden nicht behalten; nehmen Sie zuerst einige zurück.</translation>
    </message>
    <message>
        <source>The tool has no points; a tool needs at least one.</source>
        <translation>Das Werkzeug hat keine Punkte; ein Werkzeug braucht mindestens einen.</translation>
    </message>
    <message>
        <source>There is nothing to touch yet; open a volume.</source>
        <translation>Noch gibt es nichts zu tasten; öffnen Sie ein Volumen.</translation>
    </message>
    <message>
        <source>The tool would start inside the solid, with no room within 50 mm; raise the isovalue.</source>
        <translation>Das Werkzeug würde im Festen beginnen, ohne Platz innerhalb von 50 mm; erhöhen Sie den Isowert.</translation>
    </message>
    <message>
        <source>The hand has no poses.</source>
        <translation>Die Hand hat keine Posen.</translation>
    </message>
    <message>
        <source>The hand&apos;s row %1 holds something that is not a number.</source>
        <translation>Zeile %1 der Hand enthält etwas, das keine Zahl ist.</translation>
    </message>
    <message>
        <source>The hand&apos;s time does not increase at row %1.</source>
        <translation>Die Zeit der Hand nimmt in Zeile %1 nicht zu.</translation>
    </message>
    <message>
        <source>The tool finds no surface at the isovalue %1; choose a lower one.</source>
        <translation>Das Werkzeug findet beim Isowert %1 keine Oberfläche; wählen Sie einen niedrigeren.</translation>
    </message>
    <message>
        <source>The tool has a point that is not a number; mend the file.</source>
        <translation>Das Werkzeug hat einen Punkt, der keine Zahl ist; berichtigen Sie die Datei.</translation>
    </message>
    <message>
        <source>The tool has a point more than 10 m from its middle, and no hand holds that; check its unit.</source>
        <translation>Das Werkzeug hat einen Punkt, der mehr als 10 m von seiner Mitte entfernt ist, und das hält keine Hand; prüfen Sie die Einheit.</translation>
    </message>
    <message>
        <source>collision detection and contact rows in free space</source>
        <translation>Kollisionserkennung und Kontaktzeilen im freien Raum</translation>
    </message>
    <message>
        <source>in a tick in which every point of the tool has more room than the hand moved, nothing can be met; so it is always above %1, the greatest value of the volume</source>
        <translation>in einem Takt, in dem jeder Punkt des Werkzeugs mehr Raum hat, als die Hand sich bewegte, kann nichts getroffen werden; so ist es immer über %1, dem größten Wert des Volumens</translation>
    </message>
    <message>
        <source>it rests on another that was switched off</source>
        <translation>es beruht auf etwas anderem, das abgeschaltet wurde</translation>
    </message>
    <message>
        <source>it was switched off</source>
        <translation>es wurde abgeschaltet</translation>
    </message>
    <message>
        <source>sampling where the pyramid&apos;s bounds prove the volume free</source>
        <translation>Abtasten, wo die Schranken der Pyramide das Volumen als frei beweisen</translation>
    </message>
    <message>
        <source>a block below the isovalue proves whole branches of the tool free (%1 points in %2 leaves), and paths</source>
        <translation>ein Block unter dem Isowert beweist ganze Zweige des Werkzeugs als frei (%1 Punkte in %2 Blättern) und Wege</translation>
    </message>
    <message>
        <source>a block below the isovalue proves what lies in it free, points and paths; branches there are none, the tool is one leaf of %1 points</source>
        <translation>ein Block unter dem Isowert beweist, was in ihm liegt, als frei, Punkte und Wege; Zweige gibt es nicht, das Werkzeug ist ein Blatt mit %1 Punkten</translation>
    </message>
    <message>
        <source>a block below the isovalue proves what lies in it free, points and paths; branches there are none, the tool is one leaf of 1 point</source>
        <translation>ein Block unter dem Isowert beweist, was in ihm liegt, als frei, Punkte und Wege; Zweige gibt es nicht, das Werkzeug ist ein Blatt mit 1 Punkt</translation>
    </message>
    <message>
        <source>another look at points whose room is not used up</source>
        <translation>noch ein Blick auf Punkte, deren Raum nicht aufgebraucht ist</translation>
    </message>
    <message>
        <source>what was proven free stays so until the tool has moved that far</source>
        <translation>was als frei bewiesen wurde, bleibt es, bis sich das Werkzeug so weit bewegt hat</translation>
    </message>
    <message>
        <source>gradients of points beyond the contact band</source>
        <translation>Gradienten von Punkten jenseits des Kontaktbands</translation>
    </message>
    <message>
        <source>only a point within a tenth of a voxel of the surface has a row</source>
        <translation>nur ein Punkt, der höchstens ein Zehntel eines Voxels von der Oberfläche entfernt ist, hat eine Zeile</translation>
    </message>
    <message>
        <source>central differences</source>
        <translation>zentrale Differenzen</translation>
    </message>
    <message>
        <source>the rows take another normal: six of a point&apos;s seven samples would be for nothing</source>
        <translation>die Zeilen nehmen eine andere Normale: Sechs der sieben Abtastungen eines Punktes wären umsonst</translation>
    </message>
    <message>
        <source>the rows take them for their normals</source>
        <translation>die Zeilen nehmen sie für ihre Normalen</translation>
    </message>
    <message>
        <source>rows anew while the tool is still</source>
        <translation>neue Zeilen, während das Werkzeug ruht</translation>
    </message>
    <message>
        <source>at the same pose they are the same</source>
        <translation>bei derselben Pose sind sie dieselben</translation>
    </message>
    <message>
        <source>The Force Dimension SDK</source>
        <translation>Das SDK von Force Dimension</translation>
    </message>
    <message>
        <source>The keyring has logins of DICOMweb; name its server with --dicomweb, and --user unless it is a token.</source>
        <translation>Der Schlüsselbund hat Anmeldungen für DICOMweb; nennen Sie den Server mit --dicomweb und, außer bei einem Token, den Benutzer mit --user.</translation>
    </message>
    <message>
        <source>The keyring has the login for %1 now.</source>
        <translation>Der Schlüsselbund hat die Anmeldung für %1 jetzt.</translation>
    </message>
    <message>
        <source>The keyring has no login for %1 any more.</source>
        <translation>Der Schlüsselbund hat keine Anmeldung für %1 mehr.</translation>
    </message>
    <message>
        <source>The images state a transfer syntax that is no identifier; export them as explicit little endian.</source>
        <translation>Die Bilder nennen eine Transfer-Syntax, die keine Kennung ist; exportieren Sie sie als Explicit Little Endian.</translation>
    </message>
    <message>
        <source>%(1); its files state several values of %2.</source>
        <translation>%(1); ihre Dateien nennen mehrere Werte für %2.</translation>
    </message>
    <message>
        <source>The series holds several volumes; this is %1.</source>
        <translation>Die Serie enthält mehrere Volumen; dies ist %1.</translation>
    </message>
    <message>
        <source>It shows another view or has another size than the slices, as a scout has.</source>
        <translation>Sie zeigt eine andere Ansicht oder hat eine andere Größe als die Schichten, wie ein Übersichtsbild.</translation>
    </message>
    <message>
        <source>%1 %2 of %3</source>
        <translation>%1 %2 von %3</translation>
    </message>
    <message>
        <source>%1 %2 of %3 (%4)</source>
        <translation>%1 %2 von %3 (%4)</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>turned by %1 degrees</source>
        <translation>um %1 Grad gedreht</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>trigger delay</source>
        <translation>Triggerverzögerung</translation>
    </message>
    <message>
        <source>trigger time</source>
        <translation>Triggerzeit</translation>
    </message>
    <message>
        <source>phase of breath</source>
        <translation>Phase der Atmung</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>echo</source>
        <translation>Echo</translation>
    </message>
    <message>
        <source>echo time</source>
        <translation>Echozeit</translation>
    </message>
    <message>
        <source>b-value</source>
        <translation>b-Wert</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>tube voltage</source>
        <translation>Röhrenspannung</translation>
    </message>
    <message>
        <source>acquisition</source>
        <translation>Akquisition</translation>
    </message>
    <message>
        <source>kernel</source>
        <translation>Kernel</translation>
    </message>
    <message>
        <source>image type</source>
        <translation>Bildtyp</translation>
    </message>
    <message>
        <source>frame of reference</source>
        <translation>Bezugskoordinatensystem</translation>
    </message>
    <message>
        <source>stack</source>
        <translation>Stapel</translation>
    </message>
    <message>
        <source>slice thickness</source>
        <translation>Dicke der Schicht</translation>
    </message>
    <message>
        <source>voxel type</source>
        <translation>Voxeltyp</translation>
    </message>
    <message>
        <source>time of acquisition</source>
        <translation>Zeit der Aufnahme</translation>
    </message>
    <message>
        <source>time of the image</source>
        <translation>Zeit des Bildes</translation>
    </message>
    <message>
        <source>patient&apos;s name</source>
        <translation>Name des Patienten</translation>
    </message>
    <message>
        <source>series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>orientation</source>
        <translation>Orientierung</translation>
    </message>
    <message>
        <source>view</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>The slices lie %1 mm apart in one part of the stack and %2 mm in the other.</source>
        <translation>Die Schichten liegen in einem Teil des Stapels %1 mm auseinander und im anderen %2 mm.</translation>
    </message>
    <message>
        <source>The slices drift: they lie up to %1 mm off even places, though each step is near the usual one, from %2 to %3 mm.</source>
        <translation>Die Schichten driften: Sie liegen bis zu %1 mm neben gleichmäßigen Orten, obwohl jeder Schritt dem üblichen nahe ist, von %2 bis %3 mm.</translation>
    </message>
    <message>
        <source>%1 is packed as %2, which is not unpacked here; unpack it yourself and open the folder, or pack it as ZIP.</source>
        <translation>%1 ist als %2 gepackt, was hier nicht entpackt wird; entpacken Sie es selbst, und öffnen Sie den Ordner, oder packen Sie es als ZIP.</translation>
    </message>
    <message>
        <source>%1 is packed by %2 and no archive is found in it; unpack it yourself and open what comes out.</source>
        <translation>%1 ist mit %2 gepackt, und darin ist kein Archiv zu finden; entpacken Sie es selbst, und öffnen Sie, was herauskommt.</translation>
    </message>
    <message>
        <source>The data file %2 that the header %1 names is missing; copy it beside the header.</source>
        <translation>Die Datendatei %2, die der Kopf %1 nennt, fehlt; kopieren Sie sie neben den Kopf.</translation>
    </message>
    <message>
        <source>The axes are %1 degrees off their right angles, which is taken for rounding and set right.</source>
        <translation>Die Achsen weichen um %1 Grad von ihren rechten Winkeln ab, was als Rundung gilt und berichtigt wird.</translation>
    </message>
    <message>
        <source>The header of %1 has something other than numbers (&quot;1.5&quot;, with a point and without a unit) in &quot;%2&quot;, or too many or too few of them; correct it or export it again.</source>
        <translation>Der Kopf von %1 hat in „%2“ etwas anderes als Zahlen („1.5“, mit Punkt und ohne Einheit) oder zu viele oder zu wenige davon; berichtigen Sie ihn, oder exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>The axes of the sform are %1 degrees off their right angles, so the qform places the volume.</source>
        <translation>Die Achsen der sform weichen um %1 Grad von ihren rechten Winkeln ab; darum gilt die qform.</translation>
    </message>
    <message>
        <source>The header of %1 names %2 data files, which cannot share its %3 voxels evenly; complete the list or export it again.</source>
        <translation>Der Kopf von %1 nennt %2 Datendateien, auf die sich seine %3 Voxel nicht gleich verteilen; ergänzen Sie die Liste, oder exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>The header of %1 places its axes in a space of %2 dimensions; export it with a space of three, such as left-posterior-superior.</source>
        <translation>Der Kopf von %1 legt seine Achsen in einen Raum von %2 Dimensionen; exportieren Sie es mit einem von dreien, etwa left-posterior-superior.</translation>
    </message>
    <message>
        <source>dimension index</source>
        <translation>Dimensionsindex</translation>
    </message>
    <message>
        <source>The series seems to hold %1 volumes of %2 slices, which cannot be told apart; put each into a folder of its own.</source>
        <translation>Die Serie enthält anscheinend %1 Volumen zu je %2 Schichten, die sich nicht unterscheiden lassen; legen Sie jedes in einen eigenen Ordner.</translation>
    </message>
    <message>
        <source>%1 files of %1 studies fit together as one stack, though their identifiers do not say that they belong together.</source>
        <translation>%1 Dateien aus %1 Studien passen als ein Stapel zusammen, obwohl ihre Kennungen nicht sagen, dass sie zusammengehören.</translation>
    </message>
    <message>
        <source>diffusion direction</source>
        <translation>Diffusionsrichtung</translation>
    </message>
    <message>
        <source>exposure</source>
        <translation>Exposition</translation>
    </message>
    <message>
        <source>series description</source>
        <translation>Serienbeschreibung</translation>
    </message>
    <message>
        <source>%1 holds a dose and no image; choose the series of the scan.</source>
        <translation>%1 enthält eine Dosis und kein Bild; wählen Sie die Serie des Scans.</translation>
    </message>
    <message>
        <source>The sform places nothing, so the qform places the volume.</source>
        <translation>Die sform gibt keinen Ort an, deshalb gibt ihn die qform.</translation>
    </message>
    <message>
        <source>patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>modality</source>
        <translation>Modalität</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>Durchgang</translation>
    </message>
    <message>
        <source>A face of %1 has more than %2 corners; export the mesh again as triangles.</source>
        <translation>Eine Fläche von %1 hat mehr als %2 Ecken; exportieren Sie das Gitternetz neu als Dreiecke.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no regular file: it is a folder, a pipe or a device; name a file.</source>
        <translation>„%1“ ist keine gewöhnliche Datei, sondern ein Ordner, eine Pipe oder ein Gerät; nennen Sie eine Datei.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is larger than %2, and no such file is; choose another.</source>
        <translation>„%1“ ist größer als %2, und das ist keine solche Datei; wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has more numbers in line %2 than names in its first line; write them with decimal points, separated by commas.</source>
        <translation>„%1“ hat in Zeile %2 mehr Zahlen als Namen in der ersten Zeile; schreiben Sie sie mit Dezimalpunkten, durch Kommas getrennt.</translation>
    </message>
    <message>
        <source>Line %2 of &quot;%1&quot; is longer than 64 kB; check that it is a table.</source>
        <translation>Zeile %2 von „%1“ ist länger als 64 kB; prüfen Sie, ob es eine Tabelle ist.</translation>
    </message>
    <message>
        <source>Beside &quot;%1&quot; lies &quot;%2&quot;, which Palpate did not make and which would change the recording; move it elsewhere first.</source>
        <translation>Neben „%1“ liegt „%2“; Palpate hat diese Datei nicht gemacht, und sie würde die Aufzeichnung ändern. Legen Sie sie zuerst woanders hin.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be recovered: the file has another name too, and would be changed under it; recover a copy.</source>
        <translation>„%1“ kann nicht wiederhergestellt werden: die Datei hat noch einen anderen Namen und würde auch unter ihm geändert; stellen Sie eine Kopie wieder her.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a file that was read here, and would be lost; name another.</source>
        <translation>„%1“ ist eine Datei, die hier gelesen wurde und verloren ginge; nennen Sie eine andere.</translation>
    </message>
    <message>
        <source>There is no ffmpeg, so the film would be &quot;%1&quot;, which is there already; name it to write over it, or remove it.</source>
        <translation>Ohne ffmpeg wäre der Film „%1“, und diese Datei gibt es schon; nennen Sie sie, um sie zu überschreiben, oder entfernen Sie sie.</translation>
    </message>
    <message>
        <source>The file %1 states no rescale slope and intercept, and others of the series do, so its values would be off by them; export the series again.</source>
        <translation>Die Datei %1 nennt weder Rescale Slope noch Intercept, andere der Serie aber schon; ihre Werte lägen um sie daneben. Exportieren Sie die Serie neu.</translation>
    </message>
    <message>
        <source>The file %1 states the element %2 twice, with two values; export it again.</source>
        <translation>Die Datei %1 nennt das Element %2 zweimal, mit zwei Werten; exportieren Sie sie neu.</translation>
    </message>
    <message>
        <source>The file %1 holds its pixels as floating-point numbers (%2), which is not read; export it with whole numbers.</source>
        <translation>Die Datei %1 enthält ihre Pixel als Gleitkommazahlen (%2), die nicht gelesen werden; exportieren Sie sie mit ganzen Zahlen.</translation>
    </message>
    <message>
        <source>patient&apos;s date of birth</source>
        <translation>Geburtsdatum des Patienten</translation>
    </message>
    <message>
        <source>issuer of the patient&apos;s identifier</source>
        <translation>Aussteller der Patientenkennung</translation>
    </message>
    <message>
        <source>The system has no thread left for the touch; close other programs and try again.</source>
        <translation>Das System hat keinen Thread mehr für das Abtasten; schließen Sie andere Programme und versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>There is no &quot;%1&quot;; choose one of %2, or a file.</source>
        <translation>„%1“ gibt es nicht; wählen Sie eines von %2, oder eine Datei.</translation>
    </message>
    <message>
        <source>This palpate-cli was built without readers and opens no scans or meshes; use --phantom, a named tool or a CSV of points, or the desktop build.</source>
        <translation>Dieses palpate-cli wurde ohne Leser gebaut und öffnet keine Aufnahmen oder Gitternetze; verwenden Sie --phantom, ein benanntes Werkzeug oder eine CSV-Datei von Punkten, oder den Desktop-Build.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds no rows.</source>
        <translation>„%1“ enthält keine Zeilen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not opened: its field &quot;%2&quot; is missing or wrong; use a copy of the file.</source>
        <translation>„%1“ wurde nicht geöffnet: Das Feld „%2“ fehlt oder ist falsch; verwenden Sie eine Kopie der Datei.</translation>
    </message>
    <message>
        <source>No %1 is plugged in; plug in its cables, and switch it on.</source>
        <translation>Kein Gerät „%1“ ist angeschlossen; stecken Sie seine Kabel an, und schalten Sie es ein.</translation>
    </message>
    <message>
        <source>The Novint Falcon&apos;s firmware file &apos;%1&apos; is empty, too large or cannot be read; choose the one that came with the Falcon&apos;s own software.</source>
        <translation>Die Firmwaredatei „%1“ des Novint Falcon ist leer, zu groß oder lässt sich nicht lesen; wählen Sie die aus der Software, die dem Falcon beilag.</translation>
    </message>
    <message>
        <source>The %1 could not be opened (%2); switch it off and on, or unplug it and plug it in again.</source>
        <translation>%1 ließ sich nicht öffnen (%2); schalten Sie das Gerät aus und ein, oder ziehen Sie es ab und stecken Sie es wieder an.</translation>
    </message>
    <message>
        <source>%1: %2 cannot be loaded (%3); install it from its maker&apos;s site, where the system looks for libraries.</source>
        <translation>%1: %2 lässt sich nicht laden (%3); installieren Sie es von der Website des Herstellers an einem Ort, an dem das System nach Bibliotheken sucht.</translation>
    </message>
    <message>
        <source>%1 is not installed (looked for %2); install it from its maker&apos;s site, where the system looks for libraries.</source>
        <translation>%1 ist nicht installiert (gesucht wurde %2); installieren Sie es von der Website des Herstellers an einem Ort, an dem das System nach Bibliotheken sucht.</translation>
    </message>
    <message>
        <source>Palpate has the %1 open; disconnect it first.</source>
        <translation>Palpate hat %1 geöffnet; trennen Sie zuerst die Verbindung.</translation>
    </message>
    <message>
        <source>Force Dimension device</source>
        <translation>Gerät von Force Dimension</translation>
    </message>
    <message>
        <source>Touch or PHANTOM</source>
        <translation>Touch oder PHANTOM</translation>
    </message>
    <message>
        <source>%1 is too old (%2 lacks %3); install a newer one from its maker&apos;s site.</source>
        <translation>%1 ist zu alt (%2 hat kein %3); installieren Sie eine neuere Version von der Website des Herstellers.</translation>
    </message>
    <message>
        <source>The recording goes from %1 s to %2 s and has no step in the chosen time; choose another.</source>
        <translation>Die Aufzeichnung reicht von %1 s bis %2 s und hat in der gewählten Zeit keinen Schritt; wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>A film is 64 to 7680 pixels wide and high, both even, has 1 to 240 frames a second, and runs at 0.001 to 1000 times the speed of the session.</source>
        <translation>Ein Film ist 64 bis 7680 Pixel breit und hoch, beides gerade, hat 1 bis 240 Bilder je Sekunde und läuft mit dem 0,001- bis 1000-Fachen der Geschwindigkeit der Sitzung.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not permit &quot;%2&quot; this; ask its administrator for permission to search and retrieve.</source>
        <translation>„%1“ erlaubt „%2“ dies nicht; bitten Sie den Administrator um die Erlaubnis, zu suchen und abzurufen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; answered with the status %2; ask its administrator.</source>
        <translation>„%1“ antwortete mit dem Status %2; fragen Sie den Administrator.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; sent an answer that is not understood; ask its administrator.</source>
        <translation>„%1“ sendete eine Antwort, die nicht zu verstehen ist; fragen Sie den Administrator.</translation>
    </message>
    <message>
        <source>The server&apos;s answer is not one that DICOMweb has; check the path of the URL.</source>
        <translation>Die Antwort des Servers ist keine, die DICOMweb kennt; prüfen Sie den Pfad der URL.</translation>
    </message>
    <message>
        <source>Compressed images are decoded by the program %1, which could not be started, or not confined to its work on this system; install Palpate again, or export the images as explicit little endian.</source>
        <translation>Komprimierte Bilder decodiert das Programm %1, das sich nicht starten oder auf diesem System nicht auf seine Arbeit beschränken ließ; installieren Sie Palpate noch einmal, oder exportieren Sie die Bilder als Explicit Little Endian.</translation>
    </message>
    <message>
        <source>%1 is damaged or cut off; copy or fetch it again.</source>
        <translation>%1 ist beschädigt oder abgeschnitten; kopieren oder holen Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>The images are stored in the transfer syntax %1, which cannot be decoded; export them as explicit little endian.</source>
        <translation>Die Bilder sind in der Transfersyntax %1 gespeichert, die sich nicht decodieren lässt; exportieren Sie sie als Explicit Little Endian.</translation>
    </message>
    <message>
        <source>The series holds no image; choose the series of the scan.</source>
        <translation>Die Serie enthält kein Bild; wählen Sie die Serie der Aufnahme.</translation>
    </message>
    <message>
        <source>The file %1 states a number, size or depth of its pixels that no image has; export it again.</source>
        <translation>Die Datei %1 nennt eine Zahl, Größe oder Tiefe ihrer Pixel, die kein Bild hat; exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>The file %1 states no usable pair of rescale slope and intercept; export it again.</source>
        <translation>Die Datei %1 nennt kein brauchbares Paar von Rescale Slope und Intercept; exportieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>Files that are no images of this stack are left out: %1; the first is %2.</source>
        <translation>Dateien, die keine Bilder dieses Stapels sind, werden ausgelassen: %1; die erste ist %2.</translation>
    </message>
    <message>
        <source>A single slice of unknown thickness, taken to be 1 mm thick.</source>
        <translation>Eine einzelne Schicht unbekannter Dicke, die als 1 mm dick gilt.</translation>
    </message>
    <message>
        <source>%(1); copies of its slices in the folder are left out: %2.</source>
        <translation>%(1); Kopien seiner Schichten im Ordner wurden ausgelassen: %2.</translation>
    </message>
    <message>
        <source>A slice of the series has a position, orientation or pixel spacing that makes no sense; export the series again.</source>
        <translation>Eine Schicht der Serie hat eine Position, eine Ausrichtung oder einen Pixelabstand, der keinen Sinn ergibt; exportieren Sie die Serie noch einmal.</translation>
    </message>
    <message>
        <source>The volume&apos;s spacing, orientation or origin is not a number, or not one that can be; export it again with its geometry.</source>
        <translation>Abstand, Ausrichtung oder Ursprung des Volumens ist keine Zahl oder keine mögliche; exportieren Sie es noch einmal mit seiner Geometrie.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>A vertex of %1 is not three finite numbers; export the mesh again.</source>
        <translation>Ein Eckpunkt von %1 besteht nicht aus drei endlichen Zahlen; exportieren Sie das Gitternetz noch einmal.</translation>
    </message>
    <message>
        <source>A face of %1 has fewer than three corners or names a vertex that is not there; export the mesh again.</source>
        <translation>Eine Fläche von %1 hat weniger als drei Ecken oder nennt einen Eckpunkt, den es nicht gibt; exportieren Sie das Gitternetz noch einmal.</translation>
    </message>
    <message>
        <source>The memory of this machine does not hold %1; close other programs, or choose something smaller.</source>
        <translation>Der Speicher dieses Rechners fasst %1 nicht; schließen Sie andere Programme, oder wählen Sie etwas Kleineres.</translation>
    </message>
    <message>
        <source>The voxels of %1 are colours, vectors or complex numbers; export a volume of one value per voxel.</source>
        <translation>Die Voxel von %1 sind Farben, Vektoren oder komplexe Zahlen; exportieren Sie ein Volumen mit einem Wert je Voxel.</translation>
    </message>
    <message>
        <source>The header of %1 states a &quot;%2&quot; that makes no sense; correct it or export it again.</source>
        <translation>Der Kopf von %1 nennt für „%2“ etwas, das keinen Sinn ergibt; berichtigen Sie ihn, oder exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>The header of %1 measures in a unit that is no length known here, or in several; export it in millimetres.</source>
        <translation>Der Kopf von %1 misst in einer Einheit, die keine hier bekannte Länge ist, oder in mehreren; exportieren Sie die Datei in Millimetern.</translation>
    </message>
    <message>
        <source>The header of %1 does not state the spacing and direction of every axis; export it again with its geometry.</source>
        <translation>Der Kopf von %1 nennt nicht für jede Achse Abstand und Richtung; exportieren Sie die Datei noch einmal mit ihrer Geometrie.</translation>
    </message>
    <message>
        <source>Empty files beside the slices: %1; if the series lacks slices, copy it again.</source>
        <translation>Leere Dateien neben den Schichten: %1; wenn der Serie Schichten fehlen, kopieren Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>Damaged DICOM files beside the slices, which may belong to them: %1; copy the folder again.</source>
        <translation>Beschädigte DICOM-Dateien neben den Schichten, die zu ihnen gehören können: %1; kopieren Sie den Ordner noch einmal.</translation>
    </message>
    <message>
        <source>Files beside the slices that may not be read: %1; if the series lacks slices, change their permissions.</source>
        <translation>Dateien neben den Schichten, die nicht gelesen werden dürfen: %1; wenn der Serie Schichten fehlen, ändern Sie die Zugriffsrechte.</translation>
    </message>
    <message>
        <source>%1 holds no scan that is known here (DICOM, NRRD, MetaImage or NIfTI); open the folder of a series.</source>
        <translation>%1 enthält keine hier bekannte Aufnahme (DICOM, NRRD, MetaImage oder NIfTI); öffnen Sie den Ordner einer Serie.</translation>
    </message>
    <message>
        <source>The header of %1 lacks the field &quot;%2&quot;; export it again.</source>
        <translation>Im Kopf von %1 fehlt das Feld „%2“; exportieren Sie die Datei noch einmal.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be recovered: it is no unfinished recording; those end in .palpate.part.</source>
        <translation>„%1“ lässt sich nicht wiederherstellen: Es ist keine unfertige Aufzeichnung; diese enden auf .palpate.part.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged, or is no recording of Palpate&apos;s; recordings end in .palpate.</source>
        <translation>„%1“ ist beschädigt oder keine Aufzeichnung von Palpate; Aufzeichnungen enden auf .palpate.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is of a later Palpate; use that one.</source>
        <translation>„%1“ ist von einem neueren Palpate; verwenden Sie dieses.</translation>
    </message>
    <message>
        <source>There is no &quot;%1&quot;; choose one of %2.</source>
        <translation>„%1“ gibt es nicht; wählen Sie eines von %2.</translation>
    </message>
    <message>
        <source>There is no edit to undo or redo.</source>
        <translation>Es gibt keine Bearbeitung zum Rückgängigmachen oder Wiederholen.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be opened; check the path and who may read it.</source>
        <translation>„%1“ kann nicht geöffnet werden; prüfen Sie den Pfad und wer die Datei lesen darf.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged, or is no view of Palpate&apos;s; views end in .palpate-view.</source>
        <translation>„%1“ ist beschädigt oder keine Ansicht von Palpate; Ansichten enden auf .palpate-view.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written (%2); choose a folder that can be written and has room.</source>
        <translation>„%1“ lässt sich nicht schreiben (%2); wählen Sie einen Ordner, der beschreibbar ist und Platz hat.</translation>
    </message>
    <message>
        <source>%1 cannot be read as a mesh; export it again as binary STL.</source>
        <translation>%1 lässt sich nicht als Gitternetz lesen; exportieren Sie die Datei noch einmal als binäres STL.</translation>
    </message>
    <message>
        <source>ffmpeg ended before the film was whole (%1); check the room on the disk, and that ffmpeg has libx264.</source>
        <translation>ffmpeg endete, bevor der Film vollständig war (%1); prüfen Sie den Platz auf dem Datenträger, und ob ffmpeg libx264 enthält.</translation>
    </message>
    <message>
        <source>The view &quot;%1&quot; belongs to another scan; give the view of this one, or none.</source>
        <translation>Die Ansicht „%1“ gehört zu einer anderen Aufnahme; geben Sie die Ansicht dieser Aufnahme an oder keine.</translation>
    </message>
    <message>
        <source>There is no ffmpeg, which makes MP4 films; install the package ffmpeg, or let the film&apos;s name end in .ogv.</source>
        <translation>ffmpeg fehlt, das MP4-Filme macht; installieren Sie das Paket ffmpeg, oder lassen Sie den Namen des Films auf .ogv enden.</translation>
    </message>
    <message>
        <source>There is no surface at the isovalue %1; choose one between %2 and %3, the range of the scan.</source>
        <translation>Beim Isowert %1 gibt es keine Oberfläche; wählen Sie einen zwischen %2 und %3, dem Bereich der Aufnahme.</translation>
    </message>
    <message>
        <source>The surface has %1 triangles, which is more than a file of this format can count; choose another isovalue, or crop the scan.</source>
        <translation>Die Oberfläche hat %1 Dreiecke, mehr als eine Datei dieses Formats zählen kann; wählen Sie einen anderen Isowert, oder beschneiden Sie die Aufnahme.</translation>
    </message>
    <message>
        <source>The surface was not written, since a check found that it is not closed, or not turned outwards; choose an isovalue beside this one.</source>
        <translation>Die Oberfläche wurde nicht geschrieben, denn eine Prüfung fand, dass sie nicht geschlossen oder nicht nach außen gewendet ist; wählen Sie einen Isowert daneben.</translation>
    </message>
    <message>
        <source>Volume %1 of %2. %3</source>
        <translation>Volumen %1 von %2. %3</translation>
    </message>
    <message>
        <source>At the isovalue %1 the whole scan is solid, and its surface is a box; choose an isovalue above %2, the least value of the scan, up to %3, the greatest.</source>
        <translation>Beim Isowert %1 ist der ganze Scan fest, und seine Oberfläche ist ein Quader; wählen Sie einen Isowert über %2, dem kleinsten Wert des Scans, bis %3, dem größten.</translation>
    </message>
    <message>
        <source>Axis %1 of %2, counted from 1, is of kind %3 and holds no places; export a volume of three axes and one value per voxel.</source>
        <translation>Achse %1 von %2, von 1 an gezählt, ist von der Art %3 und enthält keine Orte; exportieren Sie ein Volumen mit drei Achsen und einem Wert je Voxel.</translation>
    </message>
    <message>
        <source>Every voxel of the volume is %1, so it has no surface to touch; choose another series, or check the file.</source>
        <translation>Jedes Voxel des Volumens ist %1, also hat es keine Oberfläche zum Berühren; wählen Sie eine andere Serie, oder prüfen Sie die Datei.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has a number in column %2 of line %3 that is not finite; mend it.</source>
        <translation>„%1“ hat in Spalte %2 von Zeile %3 eine Zahl, die nicht endlich ist; berichtigen Sie sie.</translation>
    </message>
    <message>
        <source>Column %2 of &quot;%1&quot; is called &quot;%3&quot;, where %4 belongs; the first eight columns of a hand are %5.</source>
        <translation>Spalte %2 von „%1“ heißt „%3“, wo %4 hingehört; die ersten acht Spalten einer Hand sind %5.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has a rotation in line %2 that is no unit quaternion.</source>
        <translation>„%1“ hat in Zeile %2 eine Drehung, die kein Einheitsquaternion ist.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; leads the hand further away than 100 m in line %2, which no hand goes; its positions are in metres.</source>
        <translation>„%1“ führt die Hand in Zeile %2 weiter als 100 m weg, was keine Hand tut; die Orte sind in Metern.</translation>
    </message>
    <message>
        <source>The time of &quot;%1&quot; does not increase in line %2; each row needs a later time than the one before.</source>
        <translation>Die Zeit von „%1“ nimmt in Zeile %2 nicht zu; jede Zeile braucht eine spätere Zeit als die vorige.</translation>
    </message>
    <message>
        <source>Its voxels are 64-bit floating-point numbers, which were rounded to 32 bits.</source>
        <translation>Seine Voxel sind Gleitkommazahlen von 64 Bit; sie wurden auf 32 Bit gerundet.</translation>
    </message>
    <message>
        <source>No table or holder was found beside the patient; take it away with the scalpel, or as a piece.</source>
        <translation>Neben dem Patienten wurde kein Tisch und keine Halterung gefunden; entfernen Sie sie mit dem Skalpell oder als Stück.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is a recording, not a scan; palpate-cli replay and palpate-cli export read it.</source>
        <translation>„%1“ ist eine Aufzeichnung, kein Scan; palpate-cli replay und palpate-cli export lesen sie.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be recovered: it is damaged, or &quot;%2&quot;, which holds what was recorded, is not beside it; copy both.</source>
        <translation>„%1“ kann nicht wiederhergestellt werden: die Datei ist beschädigt, oder „%2“, worin die Aufzeichnung steht, liegt nicht daneben; kopieren Sie beide.</translation>
    </message>
    <message>
        <source>%1 marks nothing: all its voxels are 0.</source>
        <translation>%1 markiert nichts: Alle seine Voxel sind 0.</translation>
    </message>
    <message>
        <source>%1 has more than 255 structures; choose the file of the segmentation, not the scan, or export fewer segments.</source>
        <translation>%1 hat mehr als 255 Strukturen; wählen Sie die Datei der Segmentierung, nicht die Aufnahme, oder exportieren Sie weniger Segmente.</translation>
    </message>
    <message>
        <source>The structures overlap in more than 255 ways; export them as several files.</source>
        <translation>Die Strukturen überlappen sich auf mehr als 255 Arten; exportieren Sie sie als mehrere Dateien.</translation>
    </message>
    <message>
        <source>The scan or %1 does not state its orientation, so the two cannot be put together; export both with their orientation.</source>
        <translation>Die Aufnahme oder %1 gibt ihre Lage nicht an, deshalb lassen sich die beiden nicht zusammenbringen; exportieren Sie beide mit ihrer Lage.</translation>
    </message>
    <message>
        <source>There is no memory for the structures; close other programs.</source>
        <translation>Für die Strukturen ist kein Speicher da; schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>%1 has values that are not whole numbers of at most seven digits, so it is no label map; export the segmentation as a label map.</source>
        <translation>%1 hat Werte, die keine ganzen Zahlen mit höchstens sieben Stellen sind, und ist deshalb keine Label-Karte; exportieren Sie die Segmentierung als Label-Karte.</translation>
    </message>
    <message>
        <source>Line %2 of %1 has no number, name and colour as a table of 3D Slicer (.ctbl), ITK-SNAP or FreeSurfer has them; choose the table of the label map.</source>
        <translation>Zeile %2 von %1 hat nicht Nummer, Namen und Farbe, wie eine Tabelle von 3D Slicer (.ctbl), ITK-SNAP oder FreeSurfer sie hat; wählen Sie die Tabelle der Label-Karte.</translation>
    </message>
    <message>
        <source>Line %2 of %1 names a number that stands above it already; remove one.</source>
        <translation>Zeile %2 von %1 benennt eine Nummer, die schon darüber steht; entfernen Sie eine von beiden.</translation>
    </message>
    <message>
        <source>%1 names no number; choose the table of the label map.</source>
        <translation>%1 benennt keine Nummer; wählen Sie die Tabelle der Label-Karte.</translation>
    </message>
    <message>
        <source>%1 is larger than 1 MiB, so it is no table of names; choose the table of the label map.</source>
        <translation>%1 ist größer als 1 MiB und damit keine Tabelle von Namen; wählen Sie die Tabelle der Label-Karte.</translation>
    </message>
    <message>
        <source>%1 holds structures, not a scan; open the scan first, then the structures beside it.</source>
        <translation>%1 enthält Strukturen, keine Aufnahme; öffnen Sie zuerst die Aufnahme, dann die Strukturen dazu.</translation>
    </message>
    <message>
        <source>By their identifiers %1 and the scan are of two patients; open it only if you know that it belongs to this scan.</source>
        <translation>Nach ihren Kennungen sind %1 und die Aufnahme von zwei Patienten; öffnen Sie die Datei nur, wenn Sie wissen, dass sie zu dieser Aufnahme gehört.</translation>
    </message>
    <message>
        <source>%1 counts places from another origin than the scan (frame of reference), so its structures may lie elsewhere; open it only if you know that it belongs to this scan.</source>
        <translation>%1 zählt Orte von einem anderen Ursprung als die Aufnahme (Frame of Reference), ihre Strukturen können also woanders liegen; öffnen Sie die Datei nur, wenn Sie wissen, dass sie zu dieser Aufnahme gehört.</translation>
    </message>
    <message>
        <source>The frames of %1 are turned against each other, so its segments cannot be placed; export the segmentation again.</source>
        <translation>Die Einzelbilder von %1 sind gegeneinander gedreht, deshalb haben ihre Segmente keinen Ort; exportieren Sie die Segmentierung neu.</translation>
    </message>
    <message>
        <source>The frames of %1 do not lie on even planes, so its segments cannot be placed; export the segmentation as .seg.nrrd.</source>
        <translation>Die Einzelbilder von %1 liegen nicht auf gleichmäßigen Ebenen, deshalb haben ihre Segmente keinen Ort; exportieren Sie die Segmentierung als .seg.nrrd.</translation>
    </message>
    <message>
        <source>%1 has two frames of one segment at one place; export the segments of one moment alone.</source>
        <translation>%1 hat zwei Einzelbilder eines Segments an einem Ort; exportieren Sie die Segmente nur eines Zeitpunkts.</translation>
    </message>
    <message>
        <source>Contours of %1 that are not closed, or leave their plane, are left out: %2.</source>
        <translation>Konturen von %1, die nicht geschlossen sind oder ihre Ebene verlassen, sind weggelassen: %2.</translation>
    </message>
    <message>
        <source>%1 has no closed contour, so it marks no part of the scan; export the structures as closed contours.</source>
        <translation>%1 hat keine geschlossene Kontur und markiert deshalb keinen Teil der Aufnahme; exportieren Sie die Strukturen als geschlossene Konturen.</translation>
    </message>
    <message>
        <source>%1 is no label map that is read here; choose a file in .seg.nrrd, NRRD, MetaImage, NIfTI, a DICOM segmentation or structure set, or a surface in STL, OBJ or PLY.</source>
        <translation>%1 ist keine Label-Karte, die hier gelesen wird; wählen Sie eine Datei in .seg.nrrd, NRRD, MetaImage, NIfTI, eine DICOM-Segmentierung, einen DICOM-Struktursatz oder eine Oberfläche in STL, OBJ oder PLY.</translation>
    </message>
    <message>
        <source>%1 does not state whether its x points to the patient&apos;s left (LPS) or right (RAS), so left and right are unknown; state it as the program that wrote it has it.</source>
        <translation>%1 gibt nicht an, ob x nach links (LPS) oder rechts (RAS) vom Patienten zeigt, links und rechts sind also unbekannt; geben Sie es so an, wie es das Programm hält, das die Datei geschrieben hat.</translation>
    </message>
    <message>
        <source>%1 states another space (LPS or RAS) than was asked for, or both; leave it out, or export the surface again.</source>
        <translation>%1 nennt einen anderen Raum (LPS oder RAS) als verlangt oder beide; lassen Sie die Angabe weg, oder exportieren Sie die Oberfläche neu.</translation>
    </message>
    <message>
        <source>%1 is no closed surface, so nothing lies inside; close it or export the segmentation instead. Open edges: %2.</source>
        <translation>%1 ist keine geschlossene Oberfläche, also liegt nichts darin; schließen Sie sie, oder exportieren Sie stattdessen die Segmentierung. Offene Kanten: %2.</translation>
    </message>
    <message>
        <source>The label map has no structure %1 with voxels in the scan; of its %2, info --labels tells which have.</source>
        <translation>Die Label-Karte hat keine Struktur %1 mit Voxeln in der Aufnahme; welche ihrer %2 welche haben, sagt info --labels.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no way to feel a structure; write its number and how, such as 3=softer:300, 2=guarded:2:1.5, 1=solid or 4=not-there.</source>
        <translation>„%1“ ist keine Art, eine Struktur zu spüren; schreiben Sie ihre Nummer und wie, etwa 3=softer:300, 2=guarded:2:1.5, 1=solid oder 4=not-there.</translation>
    </message>
    <message>
        <source>Distances to %1 structures are too many at a time; name %2 of them at most, with --watch.</source>
        <translation>Abstände zu %1 Strukturen zugleich sind zu viele; nennen Sie höchstens %2 davon, mit --watch.</translation>
    </message>
    <message>
        <source>Structure %1 was felt in this recording; give the label map, with --labels, and watch it.</source>
        <translation>Struktur %1 wurde in dieser Aufzeichnung gespürt; geben Sie die Label-Karte mit --labels an, und beobachten Sie sie.</translation>
    </message>
    <message>
        <source>The structures that were solid or not there in the recording come out otherwise here: the label map or this version of Palpate is another; replay with those of the recording.</source>
        <translation>Die Strukturen, die in der Aufzeichnung fest oder nicht da waren, kommen hier anders heraus: Die Label-Karte oder diese Version von Palpate ist eine andere; geben Sie sie mit denen der Aufzeichnung wieder.</translation>
    </message>
    <message>
        <source>There is too little memory to feel a structure as solid or not there; close other programs.</source>
        <translation>Der Speicher reicht nicht, um eine Struktur als fest oder nicht da zu spüren; schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>What %1 marks lies outside the scan; open the scan that was segmented.</source>
        <translation>Was %1 markiert, liegt außerhalb der Aufnahme; öffnen Sie die Aufnahme, die segmentiert wurde.</translation>
    </message>
    <message>
        <source>%2 % of what %1 marks lies outside the scan; is it of this scan?</source>
        <translation>%2 % dessen, was %1 markiert, liegt außerhalb der Aufnahme; gehört es zu dieser Aufnahme?</translation>
    </message>
    <message>
        <source>The table of names beside the label map is not used: %1</source>
        <translation>Die Tabelle der Namen neben der Segmentierung wird nicht verwendet: %1</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not saved: with so many notes and edits it would be larger than 64 MB; delete some and save again.</source>
        <translation>„%1“ wurde nicht gespeichert: Mit so vielen Notizen und Bearbeitungen wäre die Datei größer als 64 MB; löschen Sie einige und speichern Sie noch einmal.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not say what cutting a structure takes; write its number and 0.001 to 1000 J/mm3, such as 3=0.2, or 1=never.</source>
        <translation>„%1“ sagt nicht, was es braucht, eine Struktur zu schneiden; schreiben Sie ihre Nummer und 0.001 bis 1000 J/mm3, etwa 3=0.2, oder 1=never.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not say what cutting takes from a value on; write the value and 0.001 to 1000 J/mm3, such as 700=2, at most 3 times.</source>
        <translation>„%1“ sagt nicht, was das Schneiden ab einem Wert braucht; schreiben Sie den Wert und 0.001 bis 1000 J/mm3, etwa 700=2, höchstens dreimal.</translation>
    </message>
    <message>
        <source>The structures that may not be cut are those of another scan; open this one&apos;s again.</source>
        <translation>Die Strukturen, die nicht geschnitten werden dürfen, sind die einer anderen Aufnahme; öffnen Sie die dieser Aufnahme noch einmal.</translation>
    </message>
    <message>
        <source>These structures have too many parts for a choice of how they are cut; choose for fewer of them, or for smoother ones.</source>
        <translation>Diese Strukturen haben zu viele Teile für eine Wahl, wie sie geschnitten werden; wählen Sie für weniger von ihnen oder für glattere.</translation>
    </message>
</context>
<context>
    <name>QMessageBox</name>
    <message>
        <source>Read a part of it?</source>
        <translation>Einen Teil davon lesen?</translation>
    </message>
    <message>
        <source>A part of it can be read instead. The files stay as they are.</source>
        <translation>Stattdessen lässt sich ein Teil davon lesen. Die Dateien bleiben, wie sie sind.</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>3-D view</source>
        <translation>3-D-Ansicht</translation>
    </message>
    <message>
        <source>Whole window</source>
        <translation>Ganzes Fenster</translation>
    </message>
    <message>
        <source>Slice: %1</source>
        <translation>Schnittbild: %1</translation>
    </message>
    <message>
        <source>%1x, %2 by %3 pixels</source>
        <translation>%1x, %2 mal %3 Pixel</translation>
    </message>
    <message>
        <source>Picture of</source>
        <translation>Bild von</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
</context>
<context>
    <name>app::Application</name>
    <message>
        <source>No program here shows folders. The file is in &quot;%1&quot;.</source>
        <translation>Hier zeigt kein Programm Ordner. Die Datei ist in „%1“.</translation>
    </message>
    <message>
        <source>Loading</source>
        <translation>Wird geladen</translation>
    </message>
    <message>
        <source>Another hand was chosen: the device was disconnected.</source>
        <translation>Eine andere Hand wurde gewählt: Das Gerät wurde getrennt.</translation>
    </message>
    <message>
        <source>The measurement was cancelled: another hand took the device.</source>
        <translation>Die Messung wurde abgebrochen: Eine andere Hand hat das Gerät übernommen.</translation>
    </message>
    <message>
        <source>The measurement was cancelled: a recording is being replayed.</source>
        <translation>Die Messung wurde abgebrochen: Eine Aufzeichnung wird wiedergegeben.</translation>
    </message>
    <message>
        <source>A recording was opened: the device was disconnected.</source>
        <translation>Eine Aufzeichnung wurde geöffnet: Das Gerät wurde getrennt.</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Wird gelesen</translation>
    </message>
    <message>
        <source>The file was not written</source>
        <translation>Die Datei wurde nicht geschrieben</translation>
    </message>
    <message>
        <source>Making the phantom</source>
        <translation>Phantom wird erzeugt</translation>
    </message>
    <message>
        <source>No program here shows pages. The report is &quot;%1&quot;.</source>
        <translation>Kein Programm hier zeigt Seiten. Der Bericht ist „%1“.</translation>
    </message>
</context>
<context>
    <name>app::CrashController</name>
    <message>
        <source>Palpate ended unexpectedly last time.</source>
        <translation>Palpate wurde beim letzten Mal unerwartet beendet.</translation>
    </message>
    <message>
        <source>Show report</source>
        <translation>Bericht anzeigen</translation>
    </message>
    <message>
        <source>Crash report</source>
        <translation>Absturzbericht</translation>
    </message>
    <message>
        <source>A report of Palpate&apos;s last actions. It contains no names of patients, files or servers, and stays on this machine unless you copy it.</source>
        <translation>Ein Bericht über die letzten Aktionen von Palpate. Er enthält keine Namen von Patienten, Dateien oder Servern und bleibt auf diesem Rechner, solange Sie ihn nicht kopieren.</translation>
    </message>
</context>
<context>
    <name>app::CutController</name>
    <message>
        <source>Cut</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>%L1 mm</source>
        <translation>%L1 mm</translation>
    </message>
    <message>
        <source>Burr, %1</source>
        <translation>Bohrer, %1</translation>
    </message>
</context>
<context>
    <name>app::DeviceController</name>
    <message>
        <source>Haptic device</source>
        <translation>Haptisches Gerät</translation>
    </message>
    <message>
        <source>%1 will be connected when there is something to touch: open a scan, or try the demo skull.</source>
        <translation>%1 wird verbunden, sobald es etwas zu tasten gibt: Öffnen Sie eine Aufnahme, oder versuchen Sie den Demoschädel.</translation>
    </message>
    <message>
        <source>%1: the force was taken away. %2</source>
        <translation>%1: Die Kraft wurde weggenommen. %2</translation>
    </message>
</context>
<context>
    <name>app::DeviceWatch</name>
    <message>
        <source>The device could not be opened: its driver failed. Unplug it, plug it in and try again.</source>
        <translation>Das Gerät ließ sich nicht öffnen: Sein Treiber ist ausgefallen. Ziehen Sie es ab, stecken Sie es an und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>This Palpate was built without drivers of haptic devices.</source>
        <translation>Dieses Palpate wurde ohne Treiber für haptische Geräte gebaut.</translation>
    </message>
    <message>
        <source>Force Dimension device</source>
        <translation>Gerät von Force Dimension</translation>
    </message>
    <message>
        <source>Haply Inverse3</source>
        <translation>Haply Inverse3</translation>
    </message>
    <message>
        <source>Touch or PHANTOM (OpenHaptics)</source>
        <translation>Touch oder PHANTOM (OpenHaptics)</translation>
    </message>
    <message>
        <source>SpaceMouse through spacenavd</source>
        <translation>SpaceMouse über spacenavd</translation>
    </message>
</context>
<context>
    <name>app::EditController</name>
    <message>
        <source>%1 cm³</source>
        <translation>%1 cm³</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>Wird gespeichert</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Takes the last edit back</source>
        <translation>Nimmt die letzte Bearbeitung zurück</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Makes the edit again that was taken back</source>
        <translation>Macht die Bearbeitung, die zurückgenommen wurde, noch einmal</translation>
    </message>
    <message>
        <source>Take &amp;all edits back</source>
        <translation>&amp;Alle Bearbeitungen zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Crop box</source>
        <translation>&amp;Zuschneidebox</translation>
    </message>
    <message>
        <source>Clip &amp;plane</source>
        <translation>&amp;Trennebene</translation>
    </message>
    <message>
        <source>P&amp;ieces</source>
        <translation>St&amp;ücke</translation>
    </message>
    <message>
        <source>Table and &amp;holder</source>
        <translation>Tisch und &amp;Halter</translation>
    </message>
    <message>
        <source>&amp;Scalpel</source>
        <translation>&amp;Skalpell</translation>
    </message>
    <message>
        <source>All pieces smaller than %1: together %2.</source>
        <translation>Alle Stücke kleiner als %1: zusammen %2.</translation>
    </message>
    <message>
        <source>Table and holder: %1 would go.</source>
        <translation>Tisch und Halter: %1 fielen weg.</translation>
    </message>
    <message>
        <source>This piece: %1.</source>
        <translation>Dieses Stück: %1.</translation>
    </message>
    <message>
        <source>Millimetres along the scan&apos;s own axes, from its first voxel</source>
        <translation>Millimeter entlang der Achsen der Aufnahme, von ihrem ersten Voxel</translation>
    </message>
    <message>
        <source>No slice is in view to crop to; show the slices, or set the box by its numbers.</source>
        <translation>Kein Schnittbild ist zu sehen, auf das zugeschnitten werden könnte; zeigen Sie die Schnittbilder, oder stellen Sie die Box mit ihren Zahlen ein.</translation>
    </message>
    <message>
        <source>There is no surface inside the outline to measure the depth from; draw it over the surface, or cut through everything.</source>
        <translation>Innerhalb des Umrisses ist keine Oberfläche, von der die Tiefe gemessen werden könnte; ziehen Sie ihn über die Oberfläche, oder schneiden Sie durch alles.</translation>
    </message>
    <message>
        <source>There is not enough memory to show this.</source>
        <translation>Um dies zu zeigen, ist nicht genug Speicher frei.</translation>
    </message>
    <message>
        <source>A volume is being saved; wait for it, or cancel it first.</source>
        <translation>Ein Volumen wird gespeichert; warten Sie darauf, oder brechen Sie es zuerst ab.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was saved.</source>
        <translation>„%1“ wurde gespeichert.</translation>
    </message>
    <message>
        <source>There is not enough memory to save this volume.</source>
        <translation>Um dieses Volumen zu speichern, ist nicht genug Speicher frei.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; belongs to the scan that is open, and is not written over; choose another name.</source>
        <translation>„%1“ gehört zur geöffneten Aufnahme und wird nicht überschrieben; wählen Sie einen anderen Namen.</translation>
    </message>
    <message>
        <source>Remove parts</source>
        <translation>Teile entfernen</translation>
    </message>
    <message>
        <source>Table and head holder found</source>
        <translation>Tisch und Kopfhalter gefunden</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Takes them away; Undo brings them back</source>
        <translation>Nimmt sie weg; Rückgängig bringt sie zurück</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Shows in amber what would be removed</source>
        <translation>Zeigt in Bernstein, was entfernt würde</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Leaves the scan as it is</source>
        <translation>Lässt die Aufnahme, wie sie ist</translation>
    </message>
    <message>
        <source>All that is hatched goes, for the eye and the touch, soft tissue too: %1 of it is solid at the isovalue.</source>
        <translation>Alles Schraffierte wird für Auge und Hand entfernt, auch Weichgewebe: %1 davon sind beim Isowert fest.</translation>
    </message>
    <message>
        <source>Lift the tool</source>
        <translation>Werkzeug abheben</translation>
    </message>
    <message>
        <source>Takes the tool off the surface; a simulated hand gives it to the mouse</source>
        <translation>Nimmt das Werkzeug von der Oberfläche; eine simulierte Hand gibt es der Maus</translation>
    </message>
    <message>
        <source>Lift the handle of the device.</source>
        <translation>Heben Sie den Griff des Geräts an.</translation>
    </message>
    <message>
        <source>LPS, millimetres from the scan&apos;s origin</source>
        <translation>LPS, Millimeter vom Ursprung der Aufnahme</translation>
    </message>
</context>
<context>
    <name>app::EditQueue</name>
    <message>
        <source>Editing</source>
        <translation>Wird bearbeitet</translation>
    </message>
    <message>
        <source>Undo waits until the tool no longer touches.</source>
        <translation>Rückgängig wartet, bis das Werkzeug nichts mehr berührt.</translation>
    </message>
    <message>
        <source>Redo waits until the tool no longer touches.</source>
        <translation>Wiederholen wartet, bis das Werkzeug nichts mehr berührt.</translation>
    </message>
    <message>
        <source>Taking all edits back waits until the tool no longer touches.</source>
        <translation>Das Zurücknehmen aller Bearbeitungen wartet, bis das Werkzeug nichts mehr berührt.</translation>
    </message>
    <message>
        <source>This edit puts material back, and waits until the tool no longer touches.</source>
        <translation>Diese Bearbeitung bringt Material zurück und wartet, bis das Werkzeug nichts mehr berührt.</translation>
    </message>
    <message>
        <source>There is not enough memory for this edit; nothing was changed.</source>
        <translation>Für diese Bearbeitung ist nicht genug Speicher frei; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The edit could not be made: %1</source>
        <translation>Die Bearbeitung ließ sich nicht machen: %1</translation>
    </message>
    <message>
        <source>The picture of the edited volume could not be made: it still shows the volume before the edit, but you touch the edited volume. Close other programs and undo the edit.</source>
        <translation>Das Bild des bearbeiteten Volumens ließ sich nicht machen: Es zeigt noch das Volumen vor der Bearbeitung, Sie tasten aber das bearbeitete. Schließen Sie andere Programme, und machen Sie die Bearbeitung rückgängig.</translation>
    </message>
</context>
<context>
    <name>app::ExportController</name>
    <message>
        <source>This film may show a face.</source>
        <translation>Dieser Film kann ein Gesicht zeigen.</translation>
    </message>
    <message>
        <source>Make the film</source>
        <translation>Film machen</translation>
    </message>
    <message>
        <source>Export to</source>
        <translation>Exportieren nach</translation>
    </message>
    <message>
        <source>Film (*.mp4 *.ogv)</source>
        <translation>Film (*.mp4 *.ogv)</translation>
    </message>
    <message>
        <source>An export of that name is there already.</source>
        <translation>Ein Export dieses Namens ist schon da.</translation>
    </message>
    <message>
        <source>Its files are written over.</source>
        <translation>Seine Dateien werden überschrieben.</translation>
    </message>
    <message>
        <source>Write over it</source>
        <translation>Überschreiben</translation>
    </message>
    <message>
        <source>An export is under way; wait for it, or cancel it first.</source>
        <translation>Ein Export läuft; warten Sie darauf, oder brechen Sie ihn zuerst ab.</translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation>Wird exportiert</translation>
    </message>
    <message>
        <source>Reading the recording</source>
        <translation>Die Aufzeichnung wird gelesen</translation>
    </message>
    <message>
        <source>This film will show the tool alone.</source>
        <translation>Dieser Film wird nur das Werkzeug zeigen.</translation>
    </message>
    <message>
        <source>The recording is of another scan than the one on view. Open its scan first, and the film shows its surface, too.</source>
        <translation>Die Aufzeichnung gehört zu einem anderen Scan als dem gezeigten. Öffnen Sie zuerst deren Scan, dann zeigt der Film auch dessen Oberfläche.</translation>
    </message>
    <message>
        <source>Slices show the skin, and a profile can be recognised. Make the film without slices at isovalues of bone, or give it only to people with permission to see it.</source>
        <translation>Schnittbilder zeigen die Haut, und ein Profil kann erkannt werden. Machen Sie den Film ohne Schnittbilder bei Isowerten von Knochen, oder geben Sie ihn nur Personen, die ihn sehen dürfen.</translation>
    </message>
    <message>
        <source>At its isovalues skin may be drawn, and a face can be recognised. Choose isovalues of bone, for a second surface too, or give the film only to people with permission to see it.</source>
        <translation>Bei seinen Isowerten ist vielleicht Haut zu sehen, und ein Gesicht kann erkannt werden. Wählen Sie Isowerte von Knochen, auch für eine zweite Oberfläche, oder geben Sie den Film nur Personen, die ihn sehen dürfen.</translation>
    </message>
</context>
<context>
    <name>app::ExportTask</name>
    <message>
        <source>&quot;%1&quot; was exported.</source>
        <translation>„%1“ wurde exportiert.</translation>
    </message>
    <message>
        <source>There is not enough memory for this export; choose a shorter time.</source>
        <translation>Für diesen Export ist nicht genug Speicher frei; wählen Sie eine kürzere Zeit.</translation>
    </message>
    <message>
        <source>The voxels that were cut are left out: they need their scan on view.</source>
        <translation>Die geschnittenen Voxel fehlen: Dafür muss ihre Aufnahme zu sehen sein.</translation>
    </message>
</context>
<context>
    <name>app::Film</name>
    <message>
        <source>%1 s   %2 N</source>
        <translation>%1 s   %2 N</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>app::HandController</name>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>Simulated: tap</source>
        <translation>Simuliert: Tippen</translation>
    </message>
    <message>
        <source>Simulated: slide</source>
        <translation>Simuliert: Gleiten</translation>
    </message>
    <message>
        <source>Simulated: wedge</source>
        <translation>Simuliert: Keilen</translation>
    </message>
    <message>
        <source>Simulated: pry</source>
        <translation>Simuliert: Hebeln</translation>
    </message>
    <message>
        <source>Simulated: hook</source>
        <translation>Simuliert: Haken</translation>
    </message>
    <message>
        <source>Simulated: jerk</source>
        <translation>Simuliert: Rucken</translation>
    </message>
    <message>
        <source>Simulated: twist</source>
        <translation>Simuliert: Drehen</translation>
    </message>
    <message>
        <source>Hand and tool</source>
        <translation>Hand und Werkzeug</translation>
    </message>
</context>
<context>
    <name>app::IsosurfaceController</name>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Isosurface</source>
        <translation>Isofläche</translation>
    </message>
</context>
<context>
    <name>app::JournalController</name>
    <message>
        <source>Work on this scan was kept, but it cannot be read and was left out: %1</source>
        <translation>Arbeit an dieser Aufnahme wurde aufgehoben, lässt sich aber nicht lesen und wurde weggelassen: %1</translation>
    </message>
    <message>
        <source>Your work on this scan was not saved when Palpate ended.</source>
        <translation>Ihre Arbeit an dieser Aufnahme war nicht gespeichert, als Palpate endete.</translation>
    </message>
    <message>
        <source>Your work on a scan that was open before was not saved when Palpate ended.</source>
        <translation>Ihre Arbeit an einer früher geöffneten Aufnahme war nicht gespeichert, als Palpate endete.</translation>
    </message>
    <message>
        <source>&amp;Continue where you were</source>
        <translation>&amp;Weitermachen, wo Sie waren</translation>
    </message>
    <message>
        <source>Your work is not kept while you work: %1 Save the view instead.</source>
        <translation>Ihre Arbeit wird währenddessen nicht aufgehoben: %1 Speichern Sie stattdessen die Ansicht.</translation>
    </message>
    <message>
        <source>Discard the work that was kept?</source>
        <translation>Die aufgehobene Arbeit verwerfen?</translation>
    </message>
    <message>
        <source>Its marks, notes and edits cannot be brought back.</source>
        <translation>Ihre Marken, Notizen und Bearbeitungen lassen sich nicht zurückholen.</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
</context>
<context>
    <name>app::Loader</name>
    <message>
        <source>Loading was cancelled.</source>
        <translation>Das Laden wurde abgebrochen.</translation>
    </message>
    <message numerus="yes">
        <source>None of the %n series in &quot;%1&quot; can be loaded.</source>
        <translation>
            <numerusform>Die %n Serie in „%1“ lässt sich nicht laden.</numerusform>
            <numerusform>Keine der %n Serien in „%1“ lässt sich laden.</numerusform>
        </translation>
    </message>
    <message>
        <source>This series needs %1 of memory and %2 are free; close other programs.</source>
        <translation>Diese Serie braucht %1 Speicher, und %2 sind frei; schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>series %1</source>
        <translation>Serie %1</translation>
    </message>
    <message>
        <source>%1 (%2 of %3 slices)</source>
        <translation>%1 (%2 von %3 Schichten)</translation>
    </message>
    <message>
        <source>%1 (resampled)</source>
        <translation>%1 (umgerechnet)</translation>
    </message>
    <message>
        <source>%1 (every %2 voxel)</source>
        <translation>%1 (jedes %2 Voxel)</translation>
    </message>
    <message>
        <source>%1 (a box)</source>
        <translation>%1 (eine Box)</translation>
    </message>
    <message>
        <source>There is nothing to load.</source>
        <translation>Es gibt nichts zu laden.</translation>
    </message>
    <message>
        <source>There is no unit &quot;%1&quot;; choose one of m, mm, cm, in.</source>
        <translation>Es gibt keine Einheit „%1“; wählen Sie m, mm, cm oder in.</translation>
    </message>
    <message>
        <source>%1 voxels were not numbers and count as background.</source>
        <translation>%1 Voxel waren keine Zahlen und zählen als Hintergrund.</translation>
    </message>
    <message>
        <source>%1 voxels are padding, where nothing was measured, and count as air.</source>
        <translation>%1 Voxel sind Füllwerte, wo nichts gemessen wurde, und zählen als Luft.</translation>
    </message>
    <message>
        <source>There is no room for the tool near this volume at this isovalue; try a smaller tool or another isovalue.</source>
        <translation>Nahe diesem Volumen ist bei diesem Isowert kein Platz für das Werkzeug; versuchen Sie ein kleineres Werkzeug oder einen anderen Isowert.</translation>
    </message>
    <message>
        <source>There is not enough memory for this volume and tool; close other programs or take a smaller one.</source>
        <translation>Für dieses Volumen und Werkzeug ist nicht genug Speicher frei; schließen Sie andere Programme, oder nehmen Sie ein kleineres.</translation>
    </message>
    <message>
        <source>It could not be loaded: %1</source>
        <translation>Das Laden ist gescheitert: %1</translation>
    </message>
    <message>
        <source>%1 voxels have bits beyond those that the files state as stored; their values may be wrong.</source>
        <translation>%1 Voxel haben Bits jenseits derer, die die Dateien als gespeichert angeben; ihre Werte können falsch sein.</translation>
    </message>
    <message numerus="yes">
        <source>&quot;%1&quot; has %n series; choose one that can be loaded.</source>
        <translation>
            <numerusform>„%1“ hat %n Serie; wählen Sie eine, die sich laden lässt.</numerusform>
            <numerusform>„%1“ hat %n Serien; wählen Sie eine, die sich laden lässt.</numerusform>
        </translation>
    </message>
    <message>
        <source>The isovalue is %1 instead of %2: the values of this volume are between %3 and %4.</source>
        <translation>Der Isowert ist %1 und nicht %2: Die Werte dieses Volumens liegen zwischen %3 und %4.</translation>
    </message>
    <message numerus="yes">
        <source>&quot;%2&quot; has %n series, and none of the number %1: the first is number 0.</source>
        <translation>
            <numerusform>„%2“ hat %n Serie, und keine mit der Nummer %1: die erste hat die Nummer 0.</numerusform>
            <numerusform>„%2“ hat %n Serien, und keine mit der Nummer %1: die erste hat die Nummer 0.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::LogController</name>
    <message>
        <source>There is no log: it was switched off, or Palpate&apos;s own folder for it cannot be written; start palpate with --log-level info.</source>
        <translation>Es gibt kein Protokoll: Es wurde ausgeschaltet, oder in den Ordner, den Palpate dafür hat, kann nicht geschrieben werden; starten Sie palpate mit --log-level info.</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>A log of Palpate&apos;s actions. It contains no names of patients, files or servers, and stays on this machine unless you copy it.</source>
        <translation>Ein Protokoll der Aktionen von Palpate. Es enthält keine Namen von Patienten, Dateien oder Servern und bleibt auf diesem Rechner, solange Sie es nicht kopieren.</translation>
    </message>
</context>
<context>
    <name>app::MarksController</name>
    <message>
        <source>Measures and marks</source>
        <translation>Maße und Markierungen</translation>
    </message>
    <message>
        <source>&amp;Measures and marks</source>
        <translation>&amp;Maße und Markierungen</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>&amp;Way of the tool from here</source>
        <translation>&amp;Weg des Werkzeugs von hier</translation>
    </message>
    <message>
        <source>Waiting for the tool.</source>
        <translation>Warten auf das Werkzeug.</translation>
    </message>
    <message>
        <source>The tool has travelled %1 since the start, %2 in a straight line.</source>
        <translation>Das Werkzeug ist seit dem Start %1 gefahren, in gerader Linie %2.</translation>
    </message>
</context>
<context>
    <name>app::Measurement</name>
    <message>
        <source>There is not enough memory for tools of so many points; close other programs.</source>
        <translation>Für Werkzeuge mit so vielen Punkten ist nicht genug Speicher frei; schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>It could not be measured: %1</source>
        <translation>Die Messung ist gescheitert: %1</translation>
    </message>
</context>
<context>
    <name>app::MeasurementController</name>
    <message>
        <source>Performance</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>The measurement was cancelled.</source>
        <translation>Die Messung wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The measurement was cancelled: another scan or tool is being loaded.</source>
        <translation>Die Messung wurde abgebrochen: Eine andere Aufnahme oder ein anderes Werkzeug wird geladen.</translation>
    </message>
    <message>
        <source>Touched with %1 at the isovalue %2, %3 N/m: simulated hands slid, tapped, hooked and wedged, on one thread of ordinary priority. A rate is carried if the tool stays, on average, within %L4 of a voxel of its place without a budget, and at most one tick in a thousand is longer than its period.</source>
        <translation>Getastet mit %1 beim Isowert %2, %3 N/m: Simulierte Hände glitten, tippten, hakten und keilten, in einem Thread mit gewöhnlicher Priorität. Eine Rate ist getragen, wenn das Werkzeug im Mittel innerhalb von %L4 eines Voxels von seinem Ort ohne Budget bleibt und höchstens ein Takt von tausend länger als seine Periode dauert.</translation>
    </message>
</context>
<context>
    <name>app::OpeningController</name>
    <message>
        <source> The tool is still %1.</source>
        <translation> Das Werkzeug ist weiterhin %1.</translation>
    </message>
    <message>
        <source>The tool &quot;%1&quot; was not taken. %2</source>
        <translation>Das Werkzeug „%1“ wurde nicht genommen. %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not opened. %2</source>
        <translation>„%1“ wurde nicht geöffnet. %2</translation>
    </message>
    <message>
        <source>%1 Still shown: %2.</source>
        <translation>%1 Weiterhin gezeigt: %2.</translation>
    </message>
    <message>
        <source>Making the phantom</source>
        <translation>Phantom wird erzeugt</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Wird gelesen</translation>
    </message>
    <message>
        <source>Preparing the tool</source>
        <translation>Werkzeug wird vorbereitet</translation>
    </message>
    <message>
        <source>The %1 items are not files of one folder: only the first, &quot;%2&quot;, is opened; open the folder that contains them all to choose among its series.</source>
        <translation>Die %1 Objekte sind keine Dateien eines Ordners: Nur das erste, „%2“, wird geöffnet; öffnen Sie den Ordner, der alle enthält, um unter seinen Serien zu wählen.</translation>
    </message>
</context>
<context>
    <name>app::PacsController</name>
    <message>
        <source>Asking the server</source>
        <translation>Server wird gefragt</translation>
    </message>
    <message>
        <source>The server answers, and lets Palpate search.</source>
        <translation>Der Server antwortet und lässt Palpate suchen.</translation>
    </message>
    <message>
        <source>Searching</source>
        <translation>Wird gesucht</translation>
    </message>
    <message>
        <source>The server has no series that match.</source>
        <translation>Der Server hat keine passenden Serien.</translation>
    </message>
    <message>
        <source>%1 series match.</source>
        <translation>%1 Serien passen.</translation>
    </message>
    <message>
        <source>Fetching</source>
        <translation>Wird geholt</translation>
    </message>
    <message>
        <source>%1 images were fetched and are opened.</source>
        <translation>%1 Bilder wurden geholt und werden geöffnet.</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>Abgebrochen.</translation>
    </message>
    <message>
        <source>palpate-fetch ended without an answer; try again.</source>
        <translation>palpate-fetch endete ohne Antwort; versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>palpate-fetch cannot be started; install it again.</source>
        <translation>palpate-fetch lässt sich nicht starten; installieren Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Storing</source>
        <translation>Wird gespeichert</translation>
    </message>
    <message>
        <source>The keyring has it now.</source>
        <translation>Der Schlüsselbund hat sie jetzt.</translation>
    </message>
    <message>
        <source>Removing</source>
        <translation>Wird entfernt</translation>
    </message>
    <message>
        <source>The keyring has it no more.</source>
        <translation>Der Schlüsselbund hat sie nicht mehr.</translation>
    </message>
    <message>
        <source>From the PACS</source>
        <translation>Vom PACS</translation>
    </message>
    <message>
        <source>Scans from a PACS need the program palpate-fetch, which is not installed; fetch the scan with another program and open its folder.</source>
        <translation>Aufnahmen aus einem PACS brauchen das Programm palpate-fetch, das nicht installiert ist; holen Sie die Aufnahme mit einem anderen Programm, und öffnen Sie ihren Ordner.</translation>
    </message>
</context>
<context>
    <name>app::PreferencesController</name>
    <message>
        <source>Some preferences could not be read and are as they were at first: %1.</source>
        <translation>Einige Einstellungen ließen sich nicht lesen und sind wie am Anfang: %1.</translation>
    </message>
</context>
<context>
    <name>app::RecordingController</name>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>The label was not kept: Palpate&apos;s own folder cannot be written; check its permissions and the room on its disk.</source>
        <translation>Die Bezeichnung wurde nicht behalten: Palpates eigener Ordner ist nicht beschreibbar; prüfen Sie seine Zugriffsrechte und den Platz auf dem Datenträger.</translation>
    </message>
    <message>
        <source>Choose a recording in the list on the tab Record; then it can be exported.</source>
        <translation>Wählen Sie eine Aufzeichnung in der Liste auf dem Reiter Aufzeichnung; dann lässt sie sich exportieren.</translation>
    </message>
    <message>
        <source>Another window is writing this recording; stop it there.</source>
        <translation>Ein anderes Fenster schreibt diese Aufzeichnung; beenden Sie sie dort.</translation>
    </message>
    <message>
        <source>The recording could not be deleted; check the permissions of its folder.</source>
        <translation>Die Aufzeichnung ließ sich nicht löschen; prüfen Sie die Zugriffsrechte ihres Ordners.</translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; was never finished. View &gt; Recording lists it: Recover restores its contents.</source>
        <translation>Die Aufzeichnung „%1“ wurde nie abgeschlossen. Ansicht &gt; Aufzeichnung listet sie auf: Wiederherstellen rettet ihren Inhalt.</translation>
    </message>
    <message>
        <source>Recordin&amp;g</source>
        <translation>Aufzeic&amp;hnung</translation>
    </message>
</context>
<context>
    <name>app::Recordings</name>
    <message>
        <source>&apos;%1&apos; is not a folder; choose one that exists.</source>
        <translation>„%1“ ist kein Ordner; wählen Sie einen, den es gibt.</translation>
    </message>
    <message>
        <source>Nothing can be written to &apos;%1&apos;; choose a folder with room that you may write to.</source>
        <translation>Nach „%1“ lässt sich nichts schreiben; wählen Sie einen beschreibbaren Ordner mit Platz.</translation>
    </message>
    <message>
        <source>(cannot be read)</source>
        <translation>(nicht lesbar)</translation>
    </message>
    <message>
        <source>another scan</source>
        <translation>eine andere Aufnahme</translation>
    </message>
</context>
<context>
    <name>app::ReplayController</name>
    <message>
        <source>that one has %1, this one %2</source>
        <translation>jenes hat %1, dieses %2</translation>
    </message>
    <message>
        <source>both have %1 at the same place, but the voxels differ</source>
        <translation>beide haben %1 an derselben Stelle, aber die Voxel unterscheiden sich</translation>
    </message>
    <message>
        <source>both have %1, but they lie at other places</source>
        <translation>beide haben %1, liegen aber an verschiedenen Stellen</translation>
    </message>
    <message>
        <source>The volume on view is not the one that was touched: %1; open that one to see it.</source>
        <translation>Das gezeigte Volumen ist nicht das, das berührt wurde: %1; öffnen Sie jenes, um es zu sehen.</translation>
    </message>
    <message>
        <source>Reading the recording</source>
        <translation>Die Aufzeichnung wird gelesen</translation>
    </message>
    <message>
        <source>What was cut until here is being cut again.</source>
        <translation>Was bis hierher geschnitten wurde, wird noch einmal geschnitten.</translation>
    </message>
</context>
<context>
    <name>app::ReportController</name>
    <message>
        <source>A report tells distances to structures: open the scan of the recording and its structures first.</source>
        <translation>Ein Bericht nennt Abstände zu Strukturen: Öffnen Sie zuerst die Aufnahme der Aufzeichnung und ihre Strukturen.</translation>
    </message>
    <message>
        <source>Save report as</source>
        <translation>Bericht speichern unter</translation>
    </message>
    <message>
        <source>Report (*.html *.json *.csv)</source>
        <translation>Bericht (*.html *.json *.csv)</translation>
    </message>
    <message>
        <source>Making the report</source>
        <translation>Der Bericht entsteht</translation>
    </message>
    <message>
        <source>The recording is of another scan than the one on view; open its scan and the structures of that.</source>
        <translation>Die Aufzeichnung gehört zu einer anderen als der gezeigten Aufnahme; öffnen Sie ihre Aufnahme und deren Strukturen.</translation>
    </message>
    <message>
        <source>The report was written: &quot;%1&quot;.</source>
        <translation>Der Bericht wurde geschrieben: „%1“.</translation>
    </message>
    <message>
        <source>The report was written: &quot;%1&quot;. The recording has other distances: it was made with other structures.</source>
        <translation>Der Bericht wurde geschrieben: „%1“. Die Aufzeichnung hat andere Abstände: Sie entstand mit anderen Strukturen.</translation>
    </message>
    <message>
        <source>Farthest inside %1: %2 mm</source>
        <translation>Am weitesten in %1: %2 mm</translation>
    </message>
    <message>
        <source>Nearest to %1: %2 mm</source>
        <translation>Am nächsten an %1: %2 mm</translation>
    </message>
    <message>
        <source>Inside %1, which was guarded: %2 mm</source>
        <translation>In %1, geschützt: %2 mm</translation>
    </message>
    <message>
        <source>Contact with %1, which was guarded: %2 N</source>
        <translation>Kontakt mit %1, geschützt: %2 N</translation>
    </message>
    <message>
        <source>Burr inside %1, which was guarded: %2 mm</source>
        <translation>Bohrer in %1, geschützt: %2 mm</translation>
    </message>
</context>
<context>
    <name>app::ScreenshotController</name>
    <message>
        <source>The view was not opened.</source>
        <translation>Die Ansicht wurde nicht geöffnet.</translation>
    </message>
</context>
<context>
    <name>app::SeriesChoice</name>
    <message>
        <source>Load the largest unbroken part</source>
        <translation>Größten lückenlosen Teil laden</translation>
    </message>
    <message>
        <source>Resample and load</source>
        <translation>Umrechnen und laden</translation>
    </message>
    <message>
        <source>Load as one stack</source>
        <translation>Als einen Stapel laden</translation>
    </message>
    <message>
        <source>Only these slices are then seen and felt, unchanged; nothing is shown beyond the gaps. The files stay unchanged.</source>
        <translation>Zu sehen und zu fühlen sind dann nur diese Schichten, unverändert; jenseits der Lücken wird nichts gezeigt. Die Dateien bleiben unverändert.</translation>
    </message>
    <message>
        <source>Look at the slices before you rely on picture and touch: they may be of several people. The files stay unchanged.</source>
        <translation>Sehen Sie die Schichten an, bevor Sie sich auf Bild und Tastgefühl verlassen: Sie können von mehreren Menschen sein. Die Dateien bleiben unverändert.</translation>
    </message>
    <message>
        <source>Picture and touch are then interpolated between the scan&apos;s own slices. The files stay unchanged.</source>
        <translation>Bild und Tastgefühl sind dann zwischen den Schichten der Aufnahme interpoliert. Die Dateien bleiben unverändert.</translation>
    </message>
    <message>
        <source>Structures of a scan. Load their scan first; then they are opened in it.</source>
        <translation>Strukturen einer Aufnahme. Laden Sie zuerst ihre Aufnahme; dann werden sie in ihr geöffnet.</translation>
    </message>
</context>
<context>
    <name>app::SessionRecording</name>
    <message>
        <source>The last recording is being finished; try again in a moment.</source>
        <translation>Die letzte Aufzeichnung wird abgeschlossen; versuchen Sie es gleich noch einmal.</translation>
    </message>
    <message>
        <source>The session was recorded: &quot;%1&quot;.</source>
        <translation>Die Sitzung wurde aufgezeichnet: „%1“.</translation>
    </message>
    <message>
        <source>The recording could not be finished: there is no memory left. It can be recovered.</source>
        <translation>Die Aufzeichnung ließ sich nicht abschließen: Es ist kein Speicher mehr frei. Sie lässt sich wiederherstellen.</translation>
    </message>
</context>
<context>
    <name>app::StructuresController</name>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>There is no scan yet; open the scan of the structures first.</source>
        <translation>Es ist noch keine Aufnahme geöffnet; öffnen Sie zuerst die der Strukturen.</translation>
    </message>
    <message>
        <source>Structure %1</source>
        <translation>Struktur %1</translation>
    </message>
    <message>
        <source>Distances to %1 structures are told at a time; tell fewer of the others.</source>
        <translation>Abstände werden zu %1 Strukturen zugleich genannt; wählen Sie andere ab.</translation>
    </message>
    <message>
        <source>Structures of another patient, or of another place, mislead.</source>
        <translation>Strukturen eines anderen Patienten oder eines anderen Ortes führen in die Irre.</translation>
    </message>
    <message>
        <source>Open anyway</source>
        <translation>Trotzdem öffnen</translation>
    </message>
    <message>
        <source>Open structures</source>
        <translation>Strukturen öffnen</translation>
    </message>
    <message>
        <source>Show the list</source>
        <translation>Liste zeigen</translation>
    </message>
    <message>
        <source>%1: %2 of memory are needed and %3 are free; close other programs.</source>
        <translation>%1: %2 Speicher sind nötig und %3 sind frei; schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>Reading the structures, %1 of memory</source>
        <translation>Strukturen werden gelesen, %1 Speicher</translation>
    </message>
    <message>
        <source>Distances to &quot;%1&quot;</source>
        <translation>Abstände zu „%1“</translation>
    </message>
    <message>
        <source>Structures lie with the scan: &quot;%1&quot;.</source>
        <translation>Bei der Aufnahme liegen Strukturen: „%1“.</translation>
    </message>
    <message numerus="yes">
        <source>%n files of structures lie with the scan.</source>
        <translation>
            <numerusform>Bei der Aufnahme liegt %n Datei mit Strukturen.</numerusform>
            <numerusform>Bei der Aufnahme liegen %n Dateien mit Strukturen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::SurfaceController</name>
    <message>
        <source>There is no surface yet; open a scan first.</source>
        <translation>Es gibt noch keine Oberfläche; öffnen Sie zuerst eine Aufnahme.</translation>
    </message>
    <message>
        <source>A surface is being written; wait for it, or cancel it first.</source>
        <translation>Eine Oberfläche wird gerade geschrieben; warten Sie darauf, oder brechen Sie zuerst ab.</translation>
    </message>
    <message>
        <source>at the isovalue %1</source>
        <translation>beim Isowert %1</translation>
    </message>
    <message>
        <source>This surface may show a face.</source>
        <translation>Diese Oberfläche zeigt vielleicht ein Gesicht.</translation>
    </message>
    <message>
        <source>Export the surface</source>
        <translation>Oberfläche exportieren</translation>
    </message>
    <message>
        <source>Export the surface to</source>
        <translation>Oberfläche exportieren nach</translation>
    </message>
    <message>
        <source>Surface (*%1)</source>
        <translation>Oberfläche (*%1)</translation>
    </message>
    <message>
        <source>surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Writing the surface</source>
        <translation>Die Oberfläche wird geschrieben</translation>
    </message>
    <message>
        <source>&quot;%1&quot; was exported.</source>
        <translation>„%1“ wurde exportiert.</translation>
    </message>
    <message>
        <source>It may have skin, and a face can be recognised. Choose an isovalue of bone, or give the file only to people with permission to see it.</source>
        <translation>Sie kann Haut haben, und ein Gesicht ist zu erkennen. Wählen Sie einen Isowert von Knochen, oder geben Sie die Datei nur Personen, die sie sehen dürfen.</translation>
    </message>
</context>
<context>
    <name>app::ToolController</name>
    <message>
        <source>As scanned</source>
        <translation>Wie aufgenommen</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>Geglättet</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>Aus einer Datei</translation>
    </message>
    <message>
        <source>Preparing the tool</source>
        <translation>Werkzeug wird vorbereitet</translation>
    </message>
    <message>
        <source>Preparing the field</source>
        <translation>Feld wird vorbereitet</translation>
    </message>
    <message>
        <source>Drilling</source>
        <translation>Bohren</translation>
    </message>
    <message>
        <source>Burr, 2 mm</source>
        <translation>Fräse, 2 mm</translation>
    </message>
    <message>
        <source>Burr, 4 mm</source>
        <translation>Fräse, 4 mm</translation>
    </message>
    <message>
        <source>Burr, 6 mm</source>
        <translation>Fräse, 6 mm</translation>
    </message>
    <message>
        <source>Hand drill</source>
        <translation>Handbohrer</translation>
    </message>
    <message>
        <source>Probing</source>
        <translation>Sondieren</translation>
    </message>
    <message>
        <source>Straight probe</source>
        <translation>Gerade Sonde</translation>
    </message>
    <message>
        <source>Curved probe</source>
        <translation>Gebogene Sonde</translation>
    </message>
    <message>
        <source>Hook</source>
        <translation>Häkchen</translation>
    </message>
    <message>
        <source>Elevator</source>
        <translation>Elevatorium</translation>
    </message>
    <message>
        <source>Needle</source>
        <translation>Nadel</translation>
    </message>
    <message>
        <source>Trial shapes</source>
        <translation>Probekörper</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>Cane</source>
        <translation>Gehstock</translation>
    </message>
    <message>
        <source>Wrench</source>
        <translation>Schraubenschlüssel</translation>
    </message>
    <message>
        <source>Peg</source>
        <translation>Zapfen</translation>
    </message>
    <message>
        <source>Smoothing erases %L1 % of this solid and adds %L2 %: touch and picture differ.</source>
        <translation>Das Glätten löscht %L1 % dieses Körpers und fügt %L2 % hinzu: Tastgefühl und Bild unterscheiden sich.</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Burr, 1 mm</source>
        <translation>Fräse, 1 mm</translation>
    </message>
    <message>
        <source>Burr, 3 mm</source>
        <translation>Fräse, 3 mm</translation>
    </message>
</context>
<context>
    <name>app::ViewController</name>
    <message>
        <source>The tool shows a recording; close the replay to move it.</source>
        <translation>Das Werkzeug zeigt eine Aufzeichnung; schließen Sie die Wiedergabe, um es zu bewegen.</translation>
    </message>
    <message>
        <source>There is no surface within 30 mm of this place; lower the isovalue, or choose another place.</source>
        <translation>Innerhalb von 30 mm um diese Stelle ist keine Oberfläche; senken Sie den Isowert, oder wählen Sie eine andere Stelle.</translation>
    </message>
    <message>
        <source>The tool does not fit there: it stays where it is. Choose a smaller tool, or a place with more room.</source>
        <translation>Das Werkzeug passt nicht dorthin: Es bleibt, wo es ist. Wählen Sie ein kleineres Werkzeug oder eine Stelle mit mehr Platz.</translation>
    </message>
    <message>
        <source>This picture may show a face.</source>
        <translation>Dieses Bild kann ein Gesicht zeigen.</translation>
    </message>
    <message>
        <source>Take the picture</source>
        <translation>Bild machen</translation>
    </message>
    <message>
        <source>The graphics cannot draw a picture of this size; choose a smaller one.</source>
        <translation>Die Grafik kann kein Bild dieser Größe zeichnen; wählen Sie ein kleineres.</translation>
    </message>
    <message>
        <source>Save picture as</source>
        <translation>Bild speichern unter</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>Bild (*.png)</translation>
    </message>
    <message>
        <source>&apos;%1&apos; was not written; choose a folder with room that you may write to.</source>
        <translation>„%1“ wurde nicht geschrieben; wählen Sie einen beschreibbaren Ordner mit Platz.</translation>
    </message>
    <message>
        <source>The picture was saved as &quot;%1&quot;.</source>
        <translation>Das Bild wurde als „%1“ gespeichert.</translation>
    </message>
    <message>
        <source>The picture of the 3-D view was copied.</source>
        <translation>Das Bild der 3-D-Ansicht wurde kopiert.</translation>
    </message>
    <message>
        <source>Slices show the skin, and a profile can be recognised. Take a picture of the 3-D view alone at the isovalue of bone, or give this one only to people with permission to see it.</source>
        <translation>Schnittbilder zeigen die Haut, und ein Profil kann erkannt werden. Machen Sie ein Bild der 3-D-Ansicht allein beim Isowert von Knochen, oder geben Sie dieses nur Personen, die es sehen dürfen.</translation>
    </message>
    <message>
        <source>3-D view</source>
        <translation>3-D-Ansicht</translation>
    </message>
    <message>
        <source>window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>The tool does not fit where it was: it stays where it is.</source>
        <translation>Das Werkzeug passt nicht dorthin, wo es war: es bleibt, wo es ist.</translation>
    </message>
    <message>
        <source>At its isovalues skin may be drawn, and a face can be recognised. Choose isovalues of bone, for a second surface too, or give the picture only to people with permission to see it.</source>
        <translation>Bei seinen Isowerten ist vielleicht Haut zu sehen, und ein Gesicht kann erkannt werden. Wählen Sie Isowerte von Knochen, auch für eine zweite Oberfläche, oder geben Sie das Bild nur Personen, die es sehen dürfen.</translation>
    </message>
</context>
<context>
    <name>app::ViewFileController</name>
    <message>
        <source>The view was not saved: it was cancelled.</source>
        <translation>Die Ansicht wurde nicht gespeichert: Es wurde abgebrochen.</translation>
    </message>
    <message>
        <source>%1 was not opened: a recording is on view; close it first.</source>
        <translation>%1 wurde nicht geöffnet: Eine Aufzeichnung ist zu sehen; schließen Sie diese zuerst.</translation>
    </message>
    <message>
        <source>Comparing the scan</source>
        <translation>Aufnahme wird verglichen</translation>
    </message>
    <message>
        <source>%1 was not opened: it belongs to another scan. The one on view has the same geometry, %2, but other voxels; open the other scan first.</source>
        <translation>%1 wurde nicht geöffnet: Die Ansicht gehört zu einer anderen Aufnahme. Die gezeigte hat dieselbe Geometrie, %2, aber andere Voxel; öffnen Sie zuerst die andere Aufnahme.</translation>
    </message>
    <message>
        <source>Is %1 a view of this scan?</source>
        <translation>Ist %1 eine Ansicht dieser Aufnahme?</translation>
    </message>
    <message>
        <source>It was saved by another installation, so its scan cannot be recognised. The geometry is the same: %1. Marks of another scan would lie in wrong places.</source>
        <translation>Sie wurde von einer anderen Installation gespeichert, also ist die Aufnahme nicht zu erkennen. Die Geometrie ist dieselbe: %1. Markierungen einer anderen Aufnahme lägen an falschen Stellen.</translation>
    </message>
    <message>
        <source>Open it over this scan</source>
        <translation>Über dieser Aufnahme öffnen</translation>
    </message>
    <message>
        <source>%1 was not opened: it has edits of the scan, which this Palpate cannot make.</source>
        <translation>%1 wurde nicht geöffnet: Die Ansicht hat Bearbeitungen der Aufnahme, die dieses Palpate nicht machen kann.</translation>
    </message>
    <message>
        <source>The tool of %1 is not known here; the present tool stays.</source>
        <translation>Das Werkzeug von %1 ist hier nicht bekannt; das jetzige bleibt.</translation>
    </message>
    <message>
        <source>Nothing is on view</source>
        <translation>Nichts ist zu sehen</translation>
    </message>
    <message>
        <source>The one on view has %1</source>
        <translation>Die gezeigte hat %1</translation>
    </message>
    <message>
        <source>The one on view lies elsewhere or is turned</source>
        <translation>Die gezeigte liegt anderswo oder ist gedreht</translation>
    </message>
    <message>
        <source>%1 was not opened: it belongs to a scan of %2. %3; open the other scan first.</source>
        <translation>%1 wurde nicht geöffnet: Die Ansicht gehört zu einer Aufnahme mit %2. %3; öffnen Sie zuerst die andere Aufnahme.</translation>
    </message>
    <message>
        <source>They are lost when the window closes.</source>
        <translation>Sie gehen verloren, wenn sich das Fenster schließt.</translation>
    </message>
    <message>
        <source>They are lost when another scan is opened.</source>
        <translation>Sie gehen verloren, wenn eine andere Aufnahme geöffnet wird.</translation>
    </message>
    <message>
        <source>They are lost when a view with other edits is opened.</source>
        <translation>Sie gehen verloren, wenn eine Ansicht mit anderen Bearbeitungen geöffnet wird.</translation>
    </message>
    <message>
        <source>Marks of other scans that were on view are in no file (%1). To save them, open the scan again.</source>
        <translation>Markierungen anderer Aufnahmen, die zu sehen waren, sind in keiner Datei (%1). Um sie zu speichern, öffnen Sie die Aufnahme noch einmal.</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>There is no view to save; open a scan first.</source>
        <translation>Es gibt keine Ansicht zu speichern; öffnen Sie zuerst eine Aufnahme.</translation>
    </message>
    <message>
        <source>Save the view as</source>
        <translation>Ansicht speichern unter</translation>
    </message>
    <message>
        <source>Views (*.palpate-view)</source>
        <translation>Ansichten (*.palpate-view)</translation>
    </message>
    <message>
        <source>Remember where the scan lies, relative to this file</source>
        <translation>Merken, wo die Aufnahme liegt, von dieser Datei aus</translation>
    </message>
    <message>
        <source>Saving the view</source>
        <translation>Ansicht wird gespeichert</translation>
    </message>
    <message>
        <source>The view was saved as %1.</source>
        <translation>Die Ansicht wurde als %1 gespeichert.</translation>
    </message>
    <message>
        <source>%1 was not opened: it names %2 as its scan, but %2 is not a scan; open the scan first.</source>
        <translation>%1 wurde nicht geöffnet: Die Datei nennt %2 als ihre Aufnahme, aber %2 ist keine Aufnahme; öffnen Sie zuerst die Aufnahme.</translation>
    </message>
    <message>
        <source>The isovalue of %1, %2, is outside this scan&apos;s range; %3 is shown.</source>
        <translation>Der Isowert von %1, %2, liegt außerhalb des Bereichs dieser Aufnahme; gezeigt wird %3.</translation>
    </message>
    <message>
        <source>The marks and edits of this scan are not saved.</source>
        <translation>Die Markierungen und Bearbeitungen dieser Aufnahme sind nicht gespeichert.</translation>
    </message>
    <message>
        <source>The marks of this scan are not saved.</source>
        <translation>Die Markierungen dieser Aufnahme sind nicht gespeichert.</translation>
    </message>
    <message>
        <source>The edits of this scan are not saved.</source>
        <translation>Die Bearbeitungen dieser Aufnahme sind nicht gespeichert.</translation>
    </message>
    <message>
        <source>CT</source>
        <translation>CT</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>The work that was kept</source>
        <translation>Die aufgehobene Arbeit</translation>
    </message>
    <message>
        <source>The tool of %1 comes from a file that was not found; the present tool stays. Load the tool, and open the view again.</source>
        <translation>Das Werkzeug von %1 stammt aus einer Datei, die nicht gefunden wurde; das jetzige Werkzeug bleibt. Laden Sie das Werkzeug, und öffnen Sie die Ansicht noch einmal.</translation>
    </message>
    <message>
        <source>Choose the scan…</source>
        <translation>Aufnahme wählen…</translation>
    </message>
    <message>
        <source>A &amp;folder of slices…</source>
        <translation>Ein &amp;Ordner mit Schichten…</translation>
    </message>
    <message>
        <source>A f&amp;ile…</source>
        <translation>Eine &amp;Datei…</translation>
    </message>
    <message>
        <source>Choose the scan of %1</source>
        <translation>Wählen Sie die Aufnahme von %1</translation>
    </message>
    <message>
        <source>The names of its folders are then in the file. Without it, the scan is sought among the recent places, or you choose it.</source>
        <translation>Die Namen seiner Ordner stehen dann in der Datei. Sonst wird die Aufnahme unter den letzten Orten gesucht, oder Sie wählen sie.</translation>
    </message>
</context>
<context>
    <name>app::background::Task</name>
    <message>
        <source>The system has no thread left for this; close other programs and try again.</source>
        <translation>Das System hat dafür keinen Thread mehr; schließen Sie andere Programme, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>There is not enough memory for this; close other programs and try again.</source>
        <translation>Dafür ist nicht genug Speicher frei; schließen Sie andere Programme, und versuchen Sie es noch einmal.</translation>
    </message>
</context>
<context>
    <name>app::exporting</name>
    <message>
        <source>HDF5</source>
        <translation>HDF5</translation>
    </message>
    <message>
        <source>One file of arrays, for programs that compute.</source>
        <translation>Eine Datei mit Feldern von Zahlen, für Programme, die rechnen.</translation>
    </message>
    <message>
        <source>HDF5 (*.h5)</source>
        <translation>HDF5 (*.h5)</translation>
    </message>
    <message>
        <source>MCAP</source>
        <translation>MCAP</translation>
    </message>
    <message>
        <source>One file of messages over time, for viewers of robots&apos; logs.</source>
        <translation>Eine Datei mit Nachrichten über die Zeit, für Betrachter von Roboterprotokollen.</translation>
    </message>
    <message>
        <source>MCAP (*.mcap)</source>
        <translation>MCAP (*.mcap)</translation>
    </message>
    <message>
        <source>CSV</source>
        <translation>CSV</translation>
    </message>
    <message>
        <source>One table with a line of names, and a file that explains its columns.</source>
        <translation>Eine Tabelle mit einer Zeile von Namen und eine Datei, die ihre Spalten erklärt.</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
</context>
<context>
    <name>app::geometryWords</name>
    <message>
        <source>%1 x %2 x %3 voxels of %4 x %5 x %6 mm (%7)</source>
        <translation>%1 x %2 x %3 Voxel von %4 x %5 x %6 mm (%7)</translation>
    </message>
</context>
<context>
    <name>app::phantomTitle</name>
    <message>
        <source>demo</source>
        <translation>Demoschädel</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>Kugel</translation>
    </message>
    <message>
        <source>halfspace</source>
        <translation>Halbraum</translation>
    </message>
    <message>
        <source>torus</source>
        <translation>Torus</translation>
    </message>
    <message>
        <source>gyroid</source>
        <translation>Gyroid</translation>
    </message>
    <message>
        <source>wedge</source>
        <translation>Keil</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>Loch</translation>
    </message>
    <message>
        <source>slot</source>
        <translation>Schlitz</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>Zylinder</translation>
    </message>
    <message>
        <source>marker</source>
        <translation>Marker</translation>
    </message>
    <message>
        <source>bunny</source>
        <translation>Hase</translation>
    </message>
    <message>
        <source>engine</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>mastoid</source>
        <translation>Mastoid</translation>
    </message>
</context>
<context>
    <name>app::structureTitle</name>
    <message>
        <source>Dura plate</source>
        <translation>Duraplatte</translation>
    </message>
    <message>
        <source>Sigmoid sinus</source>
        <translation>Sinus sigmoideus</translation>
    </message>
    <message>
        <source>Lateral semicircular canal</source>
        <translation>Lateraler Bogengang</translation>
    </message>
    <message>
        <source>Facial canal</source>
        <translation>Fazialiskanal</translation>
    </message>
    <message>
        <source>Facial nerve</source>
        <translation>Nervus facialis</translation>
    </message>
    <message>
        <source>Antrum</source>
        <translation>Antrum</translation>
    </message>
    <message>
        <source>Tympanic cavity</source>
        <translation>Paukenhöhle</translation>
    </message>
    <message>
        <source>Ear canal</source>
        <translation>Gehörgang</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Gehirn</translation>
    </message>
    <message>
        <source>Left eye</source>
        <translation>Linkes Auge</translation>
    </message>
    <message>
        <source>Right eye</source>
        <translation>Rechtes Auge</translation>
    </message>
    <message>
        <source>Left carotid canal</source>
        <translation>Linker Karotiskanal</translation>
    </message>
    <message>
        <source>Right carotid canal</source>
        <translation>Rechter Karotiskanal</translation>
    </message>
    <message>
        <source>Left jugular canal</source>
        <translation>Linker Jugulariskanal</translation>
    </message>
    <message>
        <source>Right jugular canal</source>
        <translation>Rechter Jugulariskanal</translation>
    </message>
    <message>
        <source>Spinal canal</source>
        <translation>Wirbelkanal</translation>
    </message>
    <message>
        <source>Burr hole</source>
        <translation>Bohrloch</translation>
    </message>
</context>
<context>
    <name>ui::Banner</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>ui::BeforeView</name>
    <message>
        <source>Unedited scan</source>
        <translation>Unbearbeitete Aufnahme</translation>
    </message>
    <message>
        <source>Before: unedited scan</source>
        <translation>Vorher: unbearbeitete Aufnahme</translation>
    </message>
    <message>
        <source>After: what is left</source>
        <translation>Nachher: was übrig ist</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Vorher</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Nachher</translation>
    </message>
</context>
<context>
    <name>ui::BoxDialog</name>
    <message>
        <source>2nd</source>
        <translation>zweite</translation>
    </message>
    <message>
        <source>3rd</source>
        <translation>dritte</translation>
    </message>
    <message>
        <source>%1th</source>
        <translation>%1te</translation>
    </message>
    <message>
        <source>Choose a box</source>
        <translation>Eine Box wählen</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Erste</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Letzte</translation>
    </message>
    <message>
        <source>Read the box</source>
        <translation>Box lesen</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Spalten</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>Slices</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>of %1</source>
        <translation>von %1</translation>
    </message>
    <message>
        <source>%1: first</source>
        <translation>%1: erste</translation>
    </message>
    <message>
        <source>%1: last</source>
        <translation>%1: letzte</translation>
    </message>
    <message>
        <source>Each end is a whole number within its axis.</source>
        <translation>Jedes Ende ist eine ganze Zahl innerhalb seiner Achse.</translation>
    </message>
    <message>
        <source>The last voxel of an axis comes before its first.</source>
        <translation>Das letzte Voxel einer Achse kommt vor ihrem ersten.</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 voxels: %4 of memory, %5 are free.</source>
        <translation>%1 × %2 × %3 Voxel: %4 Speicher, %5 sind frei.</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 voxels: %4 of memory, too much for the %5 that are free.</source>
        <translation>%1 × %2 × %3 Voxel: %4 Speicher, zu viel für die %5, die frei sind.</translation>
    </message>
    <message>
        <source>Read every second voxel (%1)</source>
        <translation>Jedes zweite Voxel lesen (%1)</translation>
    </message>
    <message>
        <source>Read every %1 voxel (%2)</source>
        <translation>Jedes %1 Voxel lesen (%2)</translation>
    </message>
    <message>
        <source>Choose a box…</source>
        <translation>Eine Box wählen…</translation>
    </message>
    <message>
        <source>Voxels to read, counted from 1:</source>
        <translation>Zu lesende Voxel, von 1 an gezählt:</translation>
    </message>
</context>
<context>
    <name>ui::ClipPlane</name>
    <message>
        <source>The three places lie on one line, which gives no plane; click three others.</source>
        <translation>Die drei Stellen liegen auf einer Geraden und ergeben keine Ebene; klicken Sie auf drei andere.</translation>
    </message>
    <message>
        <source>Drag a handle: shifts or turns the clip plane. Escape: ends.</source>
        <translation>Griff ziehen: verschiebt oder dreht die Trennebene. Esc: beendet.</translation>
    </message>
    <message>
        <source>Click, or Enter at the crosshair, three times: places the clip plane.</source>
        <translation>Dreimal klicken, oder Eingabe am Fadenkreuz: setzt die Trennebene.</translation>
    </message>
</context>
<context>
    <name>ui::Colouring</name>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Airway</source>
        <translation>Atemwege</translation>
    </message>
    <message>
        <source>Vessels with contrast</source>
        <translation>Gefäße mit Kontrastmittel</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Zähne</translation>
    </message>
</context>
<context>
    <name>ui::CropBox</name>
    <message>
        <source>Drag a handle: moves a face of the crop box. Escape: ends.</source>
        <translation>Griff ziehen: verschiebt eine Seite der Zuschneidebox. Esc: beendet.</translation>
    </message>
</context>
<context>
    <name>ui::CutPanel</name>
    <message>
        <source>Speed of the burr</source>
        <translation>Drehzahl des Bohrers</translation>
    </message>
    <message>
        <source> /min</source>
        <translation> /min</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Colour what was cut</source>
        <translation>Geschnittenes färben</translation>
    </message>
    <message>
        <source>Turns in a minute: a faster burr removes more with the same force</source>
        <translation>Umdrehungen in einer Minute: Ein schnellerer Bohrer nimmt mit derselben Kraft mehr weg</translation>
    </message>
    <message>
        <source>What it takes to remove a cubic millimetre: the more, the slower</source>
        <translation>Was es braucht, einen Kubikmillimeter wegzunehmen: je mehr, desto langsamer</translation>
    </message>
    <message>
        <source>Takes the last stroke or edit back</source>
        <translation>Nimmt den letzten Zug oder die letzte Bearbeitung zurück</translation>
    </message>
    <message>
        <source>Makes the stroke or edit again</source>
        <translation>Macht den Zug oder die Bearbeitung noch einmal</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Drehzahl</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Choose a burr to cut. The file never changes.</source>
        <translation>Wählen Sie zum Schneiden einen Bohrer. Die Datei ändert sich nie.</translation>
    </message>
    <message>
        <source>The burr is being prepared.</source>
        <translation>Der Bohrer wird vorbereitet.</translation>
    </message>
    <message>
        <source>A structure is solid for the touch, and would be cut. Let it be felt in another way to cut.</source>
        <translation>Eine Struktur ist für das Abtasten fest und würde geschnitten. Lassen Sie sie zum Schneiden anders spürbar sein.</translation>
    </message>
    <message>
        <source>Hold %1 in the 3-D view to cut.</source>
        <translation>Halten Sie zum Schneiden in der 3-D-Ansicht %1.</translation>
    </message>
    <message>
        <source>The burr turns: %L1 N</source>
        <translation>Der Bohrer dreht sich: %L1 N</translation>
    </message>
    <message>
        <source>Nothing was cut yet.</source>
        <translation>Es wurde noch nichts geschnitten.</translation>
    </message>
    <message>
        <source>Add a material</source>
        <translation>Material hinzufügen</translation>
    </message>
    <message>
        <source>From a value of the scan on another energy: denser bone takes longer to cut</source>
        <translation>Ab einem Wert der Aufnahme eine andere Energie: Dichterer Knochen braucht länger</translation>
    </message>
    <message>
        <source>From this value of the scan on</source>
        <translation>Ab diesem Wert der Aufnahme</translation>
    </message>
    <message>
        <source>Removes this material</source>
        <translation>Entfernt dieses Material</translation>
    </message>
    <message>
        <source>Remove this material</source>
        <translation>Dieses Material entfernen</translation>
    </message>
    <message>
        <source>Where the scan has this value or more</source>
        <translation>Wo die Aufnahme diesen Wert oder mehr hat</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Ab</translation>
    </message>
    <message>
        <source>Structures that may not be cut: %1.</source>
        <translation>Strukturen, die nicht geschnitten werden dürfen: %1.</translation>
    </message>
    <message>
        <source>Structures with an energy of their own: %1.</source>
        <translation>Strukturen mit eigener Energie: %1.</translation>
    </message>
    <message>
        <source>Vibration</source>
        <translation>Vibration</translation>
    </message>
    <message>
        <source>The burr&apos;s teeth are felt, by at most half a newton</source>
        <translation>Die Zähne des Bohrers sind zu spüren, mit höchstens einem halben Newton</translation>
    </message>
    <message>
        <source>Faces that a burr has cut stand out</source>
        <translation>Flächen, die ein Bohrer geschnitten hat, fallen auf</translation>
    </message>
    <message>
        <source>Sound of the burr</source>
        <translation>Ton des Bohrers</translation>
    </message>
    <message>
        <source>A faster burr is heard higher; under load it slows down a little, and gets louder and rougher</source>
        <translation>Ein schnellerer Bohrer klingt höher; unter Last wird er etwas langsamer, lauter und rauer</translation>
    </message>
    <message>
        <source>There is no program that plays a sound as it is made: install the utilities of PulseAudio or ALSA</source>
        <translation>Es gibt kein Programm, das einen Ton spielt, während er entsteht: Installieren Sie die Hilfsprogramme von PulseAudio oder ALSA</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Vorher und nachher</translation>
    </message>
    <message>
        <source>The unedited scan beside what is left of it, seen from the same place</source>
        <translation>Die unbearbeitete Aufnahme neben dem, was von ihr übrig ist, von derselben Stelle gesehen</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Züge</translation>
    </message>
    <message>
        <source>What each stroke has removed; Undo takes the first of the list back</source>
        <translation>Was jeder Zug entfernt hat; Rückgängig nimmt den ersten der Liste zurück</translation>
    </message>
    <message>
        <source>Removed: %1 mm³. Strokes: %2.</source>
        <translation>Entfernt: %1 mm³. Züge: %2.</translation>
    </message>
    <message>
        <source>Stroke %1: %2 mm³</source>
        <translation>Zug %1: %2 mm³</translation>
    </message>
</context>
<context>
    <name>ui::DevicePanel</name>
    <message>
        <source>Stiffness in N/m</source>
        <translation>Steifigkeit in N/m</translation>
    </message>
    <message>
        <source>The spring between hand and tool: stiff is hard, soft is yielding</source>
        <translation>Die Feder zwischen Hand und Werkzeug: steif ist hart, weich gibt nach</translation>
    </message>
    <message>
        <source>Stiffness, typed</source>
        <translation>Steifigkeit, eingetippt</translation>
    </message>
    <message>
        <source>The spring between hand and tool, as a number</source>
        <translation>Die Feder zwischen Hand und Werkzeug, als Zahl</translation>
    </message>
    <message>
        <source> N/m</source>
        <translation> N/m</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>How the surface is made from the voxels</source>
        <translation>Wie die Oberfläche aus den Voxeln entsteht</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Meshes (*.stl *.obj *.ply);;All files (*)</source>
        <translation>Gitternetze (*.stl *.obj *.ply);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>The hand on the tool: the mouse, or a simulated hand</source>
        <translation>Die Hand am Werkzeug: die Maus oder eine simulierte Hand</translation>
    </message>
    <message>
        <source>Friction of the surface on a tool that slides along it</source>
        <translation>Reibung der Oberfläche an einem Werkzeug, das an ihr entlang gleitet</translation>
    </message>
    <message>
        <source>slight</source>
        <translation>wenig</translation>
    </message>
    <message>
        <source>some</source>
        <translation>etwas</translation>
    </message>
    <message>
        <source>strong</source>
        <translation>stark</translation>
    </message>
    <message>
        <source>very strong</source>
        <translation>sehr stark</translation>
    </message>
    <message>
        <source>%1, %L2</source>
        <translation>%1, %L2</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
</context>
<context>
    <name>ui::DropArea</name>
    <message>
        <source>Drop to open</source>
        <translation>Ablegen zum Öffnen</translation>
    </message>
    <message>
        <source>Let go to open</source>
        <translation>Loslassen zum Öffnen</translation>
    </message>
</context>
<context>
    <name>ui::EditPanel</name>
    <message>
        <source>Crop</source>
        <translation>Box</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Cuts along a plane</source>
        <translation>Schneidet entlang einer Ebene</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Stücke</translation>
    </message>
    <message>
        <source>Keeps or removes connected pieces</source>
        <translation>Behält oder entfernt zusammenhängende Stücke</translation>
    </message>
    <message>
        <source>Holder</source>
        <translation>Halter</translation>
    </message>
    <message>
        <source>Removes table and head holder</source>
        <translation>Entfernt Tisch und Kopfhalter</translation>
    </message>
    <message>
        <source>Scalpel</source>
        <translation>Skalpell</translation>
    </message>
    <message>
        <source>Cuts along an outline that you draw</source>
        <translation>Schneidet entlang eines Umrisses, den Sie ziehen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Takes all edits back</source>
        <translation>Nimmt alle Bearbeitungen zurück</translation>
    </message>
    <message>
        <source>Takes the last edit back</source>
        <translation>Nimmt die letzte Bearbeitung zurück</translation>
    </message>
    <message>
        <source>Makes the edit again that was taken back</source>
        <translation>Macht die Bearbeitung, die zurückgenommen wurde, noch einmal</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Leaves everything as it is</source>
        <translation>Lässt alles, wie es ist</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Where the box ends on this side</source>
        <translation>Wo die Box an dieser Seite endet</translation>
    </message>
    <message>
        <source>Crop to view</source>
        <translation>Auf Ansicht zuschneiden</translation>
    </message>
    <message>
        <source>The box that the slices show</source>
        <translation>Die Box, die die Schnittbilder zeigen</translation>
    </message>
    <message>
        <source>Whole scan</source>
        <translation>Ganze Aufnahme</translation>
    </message>
    <message>
        <source>Takes the crop away</source>
        <translation>Nimmt den Zuschnitt weg</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Lays the plane into this slice</source>
        <translation>Legt die Ebene in dieses Schnittbild</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Position of the plane</source>
        <translation>Position der Ebene</translation>
    </message>
    <message>
        <source>Direction of the cut</source>
        <translation>Richtung des Schnitts</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Slope of the cut</source>
        <translation>Neigung des Schnitts</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Umdrehen</translation>
    </message>
    <message>
        <source>Takes the other side of the plane</source>
        <translation>Nimmt die andere Seite der Ebene</translation>
    </message>
    <message>
        <source>Place again</source>
        <translation>Neu setzen</translation>
    </message>
    <message>
        <source>Places the plane anew, with three clicks</source>
        <translation>Setzt die Ebene neu, mit drei Klicks</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schneiden</translation>
    </message>
    <message>
        <source>Cuts along the plane</source>
        <translation>Schneidet entlang der Ebene</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Towards</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Raised</source>
        <translation>Neigung</translation>
    </message>
    <message>
        <source>From slice:</source>
        <translation>Aus Schnittbild:</translation>
    </message>
    <message>
        <source>Smallest piece that stays</source>
        <translation>Kleinstes Stück, das bleibt</translation>
    </message>
    <message>
        <source> cm³</source>
        <translation> cm³</translation>
    </message>
    <message>
        <source>Pieces of a smaller volume go</source>
        <translation>Stücke mit kleinerem Volumen fallen weg</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Shows the small pieces before they go</source>
        <translation>Zeigt die kleinen Stücke, bevor sie wegfallen</translation>
    </message>
    <message>
        <source>All pieces smaller than</source>
        <translation>Alle Stücke kleiner als</translation>
    </message>
    <message>
        <source>Show table and holder</source>
        <translation>Tisch und Halter zeigen</translation>
    </message>
    <message>
        <source>Depth of the cut</source>
        <translation>Tiefe des Schnitts</translation>
    </message>
    <message>
        <source>through everything</source>
        <translation>durch alles</translation>
    </message>
    <message>
        <source>In 3-D from the nearest surface inside the outline; in a slice to both sides. 0 cuts through everything.</source>
        <translation>In 3-D von der nächsten Oberfläche innerhalb des Umrisses; in einem Schnittbild nach beiden Seiten. 0 schneidet durch alles.</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Keep only this</source>
        <translation>Nur dieses behalten</translation>
    </message>
    <message>
        <source>Removes all but the piece that is shown</source>
        <translation>Entfernt alles außer dem gezeigten Stück</translation>
    </message>
    <message>
        <source>Remove this</source>
        <translation>Dieses entfernen</translation>
    </message>
    <message>
        <source>Removes the piece that is shown</source>
        <translation>Entfernt das gezeigte Stück</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>One place is set: click two more.</source>
        <translation>Eine Stelle ist gesetzt: Klicken Sie auf zwei weitere.</translation>
    </message>
    <message>
        <source>Choose a tool to remove parts. The file never changes.</source>
        <translation>Wählen Sie ein Werkzeug, um Teile zu entfernen. Die Datei ändert sich nie.</translation>
    </message>
    <message>
        <source>Keeps the inside of a box</source>
        <translation>Behält das Innere einer Box</translation>
    </message>
    <message>
        <source>Keeps the inside of the box</source>
        <translation>Behält das Innere der Box</translation>
    </message>
    <message>
        <source>From the middle of the scan, towards the side to remove</source>
        <translation>Von der Mitte der Aufnahme zur Seite, die entfernt wird</translation>
    </message>
    <message>
        <source>Direction of the side to remove: 0° is L, 90° is P, 180° is R, −90° is A</source>
        <translation>Richtung der Seite, die entfernt wird: 0° ist L, 90° ist P, 180° ist R, −90° ist A</translation>
    </message>
    <message>
        <source>Slope of the side to remove: 90° is S, −90° is I</source>
        <translation>Neigung der Seite, die entfernt wird: 90° ist S, −90° ist I</translation>
    </message>
    <message>
        <source>Click on a piece, in 3-D or in a slice. A piece is connected at the present isovalue.</source>
        <translation>Klicken Sie auf ein Stück, in 3-D oder in einem Schnittbild. Ein Stück hängt beim jetzigen Isowert zusammen.</translation>
    </message>
    <message>
        <source>Shows the parts to remove, with their volume</source>
        <translation>Zeigt die Teile, die entfernt würden, mit ihrem Volumen</translation>
    </message>
    <message>
        <source>Finds table and head holder by rule, and shows them before they are removed. Check that no part of the patient is removed with them.</source>
        <translation>Findet Tisch und Kopfhalter nach einer Regel und zeigt sie, bevor sie entfernt werden. Prüfen Sie, dass kein Teil des Patienten mit entfernt wird.</translation>
    </message>
    <message>
        <source>Side of the outline to remove</source>
        <translation>Seite des Umrisses, die entfernt wird</translation>
    </message>
    <message>
        <source>Remove the inside</source>
        <translation>Innen entfernen</translation>
    </message>
    <message>
        <source>Remove the outside</source>
        <translation>Außen entfernen</translation>
    </message>
    <message>
        <source>Removes the parts shown</source>
        <translation>Entfernt die gezeigten Teile</translation>
    </message>
    <message>
        <source>Keeps the parts shown</source>
        <translation>Behält die gezeigten Teile</translation>
    </message>
    <message>
        <source>Click three places on the surface: everything on your side of the plane is removed. Or three in one slice: two on a line, and the third on the side to remove.</source>
        <translation>Klicken Sie auf drei Stellen der Oberfläche: Alles auf Ihrer Seite der Ebene wird entfernt. Oder auf drei in einem Schnittbild: zwei auf einer Linie und die dritte auf der Seite, die entfernt wird.</translation>
    </message>
    <message>
        <source>Two places are set: click the third, in a slice on the side to remove.</source>
        <translation>Zwei Stellen sind gesetzt: Klicken Sie auf die dritte, in einem Schnittbild auf der Seite, die entfernt wird.</translation>
    </message>
    <message>
        <source>1 edit</source>
        <translation>1 Bearbeitung</translation>
    </message>
    <message>
        <source>%L1 edits</source>
        <translation>%L1 Bearbeitungen</translation>
    </message>
    <message>
        <source>Draw an outline with the left button, in 3-D or on a slice, or click its corners; the last one twice. The cut is shown before it is made.</source>
        <translation>Zeichnen Sie mit der linken Taste einen Umriss, in 3-D oder auf einer Schicht, oder klicken Sie seine Ecken; die letzte zweimal. Vor dem Schnitt wird gezeigt, was er nimmt.</translation>
    </message>
    <message>
        <source>Removes what is hatched</source>
        <translation>Entfernt, was schraffiert ist</translation>
    </message>
    <message>
        <source>Only this piece stays. What is hatched goes.</source>
        <translation>Nur dieses Stück bleibt. Das Schraffierte wird entfernt.</translation>
    </message>
    <message>
        <source>This piece goes: it is hatched.</source>
        <translation>Dieses Stück wird entfernt: es ist schraffiert.</translation>
    </message>
    <message>
        <source>%1 from</source>
        <translation>%1 von</translation>
    </message>
    <message>
        <source>Box, %1 from</source>
        <translation>Box, %1 von</translation>
    </message>
    <message>
        <source>Box, %1 to</source>
        <translation>Box, %1 bis</translation>
    </message>
</context>
<context>
    <name>ui::ExportDialog</name>
    <message>
        <source>every step</source>
        <translation>jeder Schritt</translation>
    </message>
    <message>
        <source>at</source>
        <translation>mit</translation>
    </message>
    <message>
        <source>With the contacts of each step</source>
        <translation>Mit den Kontakten jedes Schritts</translation>
    </message>
    <message>
        <source>Export a recording</source>
        <translation>Eine Aufzeichnung exportieren</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Where the export begins, by the time of the recording</source>
        <translation>Wo der Export beginnt, nach der Zeit der Aufzeichnung</translation>
    </message>
    <message>
        <source>Where the export ends, by the time of the recording</source>
        <translation>Wo der Export endet, nach der Zeit der Aufzeichnung</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Asks for the file, then writes it</source>
        <translation>Fragt nach der Datei und schreibt sie dann</translation>
    </message>
    <message>
        <source>Writes nothing</source>
        <translation>Schreibt nichts</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Writes every tick of the servo loop</source>
        <translation>Schreibt jeden Takt der Regelschleife</translation>
    </message>
    <message>
        <source>Writes so many samples a second</source>
        <translation>Schreibt so viele Abtastwerte in der Sekunde</translation>
    </message>
    <message>
        <source>At a rate</source>
        <translation>Mit einer Rate</translation>
    </message>
    <message>
        <source> Hz</source>
        <translation> Hz</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Samples for each second</source>
        <translation>Abtastwerte für jede Sekunde</translation>
    </message>
    <message>
        <source>Writes where the tool touches, too</source>
        <translation>Schreibt auch, wo das Werkzeug berührt</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Abtastwerte</translation>
    </message>
    <message>
        <source>From where the film is seen</source>
        <translation>Von wo aus der Film gesehen wird</translation>
    </message>
    <message>
        <source>as it was recorded</source>
        <translation>wie aufgezeichnet</translation>
    </message>
    <message>
        <source>fixed, as it is now</source>
        <translation>fest, wie sie jetzt ist</translation>
    </message>
    <message>
        <source>Pixels of the film</source>
        <translation>Pixel des Films</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>Pictures for each second of the film</source>
        <translation>Bilder für jede Sekunde des Films</translation>
    </message>
    <message>
        <source>%1 a second</source>
        <translation>%1 in der Sekunde</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>This is not a number that can be taken here.</source>
        <translation>Dies ist keine Zahl, die hier genommen werden kann.</translation>
    </message>
    <message>
        <source>The end does not come after the beginning.</source>
        <translation>Das Ende kommt nicht nach dem Anfang.</translation>
    </message>
    <message>
        <source>All of it: %1 (minutes and seconds)</source>
        <translation>Alles: %1 (Minuten und Sekunden)</translation>
    </message>
    <message>
        <source>A part of it: %1 (minutes and seconds)</source>
        <translation>Ein Teil: %1 (Minuten und Sekunden)</translation>
    </message>
    <message>
        <source>%1, %2 pictures</source>
        <translation>%1, %2 Bilder</translation>
    </message>
    <message>
        <source>Format of the exported recording</source>
        <translation>Format der exportierten Aufzeichnung</translation>
    </message>
    <message>
        <source>Show force, its curve and time in the picture</source>
        <translation>Kraft, ihre Kurve und die Zeit im Bild zeigen</translation>
    </message>
    <message>
        <source>The film then has the force and the time in figures, and the curve of the force</source>
        <translation>Der Film hat dann Kraft und Zeit in Zahlen und die Kurve der Kraft</translation>
    </message>
    <message>
        <source>The 3-D view, with its colours, second surface and marks as now.</source>
        <translation>Die 3-D-Ansicht mit Farben, zweiter Oberfläche und Marken wie jetzt.</translation>
    </message>
    <message>
        <source>Show the slices through the tool beside it</source>
        <translation>Die Schichten durch das Werkzeug daneben zeigen</translation>
    </message>
    <message>
        <source>The film then has the axial, coronal and sagittal slice in a column at its right</source>
        <translation>Der Film hat dann rechts in einer Spalte die axiale, koronale und sagittale Schicht</translation>
    </message>
</context>
<context>
    <name>ui::ForcePanel</name>
    <message>
        <source>Nothing is touched</source>
        <translation>Nichts wird berührt</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Drehmoment</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>%1 mN·m</source>
        <translation>%1 mN·m</translation>
    </message>
    <message>
        <source>Touching</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>Touching %1</source>
        <translation>Berührt: %1</translation>
    </message>
    <message>
        <source>Touching %1, %2</source>
        <translation>Berührt: %1, %2</translation>
    </message>
    <message>
        <source>%1 N · %2</source>
        <translation>%1 N · %2</translation>
    </message>
    <message>
        <source>Show force, torque and curve</source>
        <translation>Kraft, Drehmoment und Kurve zeigen</translation>
    </message>
    <message>
        <source>Fold to one line</source>
        <translation>Auf eine Zeile falten</translation>
    </message>
    <message>
        <source>Force and touch</source>
        <translation>Kraft und Berührung</translation>
    </message>
</context>
<context>
    <name>ui::ForcePlot</name>
    <message>
        <source>Force over time</source>
        <translation>Kraft über der Zeit</translation>
    </message>
    <message>
        <source>force to %L1 N</source>
        <translation>Kraft bis %L1 N</translation>
    </message>
    <message>
        <source>torque to %L1 mN·m</source>
        <translation>Moment bis %L1 mN·m</translation>
    </message>
</context>
<context>
    <name>ui::ForceWords</name>
    <message>
        <source>The device does not know yet where it is.</source>
        <translation>Das Gerät weiß noch nicht, wo es ist.</translation>
    </message>
    <message>
        <source>There is something new to touch, or nothing yet.</source>
        <translation>Es gibt etwas Neues zu tasten, oder noch nichts.</translation>
    </message>
    <message>
        <source>The isovalue left the tool inside the solid; it is being brought out.</source>
        <translation>Durch den Isowert geriet das Werkzeug ins Feste; es wird herausgebracht.</translation>
    </message>
    <message>
        <source>The clutch is held.</source>
        <translation>Die Kupplung ist gedrückt.</translation>
    </message>
    <message>
        <source>The button or key that has to be held for a force is not down.</source>
        <translation>Die Taste, die für eine Kraft gehalten werden muss, ist nicht gedrückt.</translation>
    </message>
    <message>
        <source>There was a gap in the servo loop.</source>
        <translation>In der Regelschleife war eine Lücke.</translation>
    </message>
    <message>
        <source>The handle moved faster than a hand does.</source>
        <translation>Der Griff bewegte sich schneller als eine Hand.</translation>
    </message>
    <message>
        <source>The device&apos;s readings came too late.</source>
        <translation>Die Messwerte des Geräts kamen zu spät.</translation>
    </message>
    <message>
        <source>The device&apos;s position jumped.</source>
        <translation>Die Position des Geräts machte einen Sprung.</translation>
    </message>
    <message>
        <source>The servo loop stood still.</source>
        <translation>Die Regelschleife stand still.</translation>
    </message>
    <message>
        <source>Move its handle to its stops: all the way out, then all the way in.</source>
        <translation>Bewegen Sie seinen Griff bis an die Anschläge: ganz hinaus, dann ganz hinein.</translation>
    </message>
    <message>
        <source>Put its stylus into the cradle. Or put its arm to rest and press its zero button, or hold down the button of its stylus.</source>
        <translation>Stellen Sie seinen Stift in die Halterung. Oder legen Sie seinen Arm ab und drücken Sie den Nullknopf, oder halten Sie den Knopf seines Stifts gedrückt.</translation>
    </message>
    <message>
        <source>See that it has power, and wait until it has started.</source>
        <translation>Sehen Sie nach, ob es Strom hat, und warten Sie, bis es gestartet ist.</translation>
    </message>
    <message>
        <source>Its motors are hot: let it rest for some minutes.</source>
        <translation>Seine Motoren sind heiß: Lassen Sie es einige Minuten ruhen.</translation>
    </message>
    <message>
        <source>It switched its force off: press its force button, or see its lamp.</source>
        <translation>Es hat seine Kraft abgeschaltet: Drücken Sie seinen Kraftknopf, oder beachten Sie seine Lampe.</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Armed</source>
        <translation>Freigegeben</translation>
    </message>
    <message>
        <source>Rising</source>
        <translation>Steigt</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Ein</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>Arm the device to feel a force.</source>
        <translation>Geben Sie das Gerät frei, um eine Kraft zu fühlen.</translation>
    </message>
    <message>
        <source>Plug it in, then disconnect it here and connect it again.</source>
        <translation>Stecken Sie es an, dann trennen Sie es hier und verbinden Sie es wieder.</translation>
    </message>
    <message>
        <source>Let the handle rest, then arm the device again.</source>
        <translation>Lassen Sie den Griff ruhen, dann geben Sie das Gerät wieder frei.</translation>
    </message>
    <message>
        <source>Replay</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>No motors, no force</source>
        <translation>Keine Motoren, keine Kraft</translation>
    </message>
    <message>
        <source>No force yet</source>
        <translation>Noch keine Kraft</translation>
    </message>
    <message>
        <source>Nothing to touch yet</source>
        <translation>Noch nichts zu tasten</translation>
    </message>
    <message>
        <source>Force off</source>
        <translation>Kraft aus</translation>
    </message>
    <message>
        <source>Force stopped</source>
        <translation>Kraft angehalten</translation>
    </message>
    <message>
        <source>Force withheld</source>
        <translation>Kraft zurückgehalten</translation>
    </message>
    <message>
        <source>Force rising</source>
        <translation>Kraft steigt</translation>
    </message>
    <message>
        <source>Force on</source>
        <translation>Kraft ein</translation>
    </message>
    <message>
        <source>Force shown, not felt</source>
        <translation>Kraft gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>Fault: no force</source>
        <translation>Störung: keine Kraft</translation>
    </message>
    <message>
        <source>The device has not reported its position yet.</source>
        <translation>Das Gerät hat seine Position noch nicht gemeldet.</translation>
    </message>
    <message>
        <source>The computed force was not a number.</source>
        <translation>Die berechnete Kraft war keine Zahl.</translation>
    </message>
    <message>
        <source>The device is disconnected, or does not answer.</source>
        <translation>Das Gerät ist getrennt oder antwortet nicht.</translation>
    </message>
</context>
<context>
    <name>ui::GreyPreset</name>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Temporal bone</source>
        <translation>Felsenbein</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>Lung</source>
        <translation>Lunge</translation>
    </message>
    <message>
        <source>Brain</source>
        <translation>Gehirn</translation>
    </message>
    <message>
        <source>As in the file (W %1, L %2)</source>
        <translation>Wie in der Datei (W %1, C %2)</translation>
    </message>
    <message>
        <source>As in the file: %1 (W %2, L %3)</source>
        <translation>Wie in der Datei: %1 (W %2, C %3)</translation>
    </message>
    <message>
        <source>Mediastinum</source>
        <translation>Mediastinum</translation>
    </message>
</context>
<context>
    <name>ui::HapticDevicePanel</name>
    <message>
        <source>here</source>
        <translation>vorhanden</translation>
    </message>
    <message>
        <source>to be tried</source>
        <translation>zu versuchen</translation>
    </message>
    <message>
        <source>not plugged in</source>
        <translation>nicht angeschlossen</translation>
    </message>
    <message>
        <source>not permitted</source>
        <translation>nicht erlaubt</translation>
    </message>
    <message>
        <source>library missing</source>
        <translation>Bibliothek fehlt</translation>
    </message>
    <message>
        <source>service missing</source>
        <translation>Dienst fehlt</translation>
    </message>
    <message>
        <source>in use</source>
        <translation>in Gebrauch</translation>
    </message>
    <message>
        <source>needs firmware</source>
        <translation>braucht Firmware</translation>
    </message>
    <message>
        <source>needs homing</source>
        <translation>braucht Referenzfahrt</translation>
    </message>
    <message>
        <source>needs calibration</source>
        <translation>braucht Kalibrierung</translation>
    </message>
    <message>
        <source>not started</source>
        <translation>nicht gestartet</translation>
    </message>
    <message>
        <source>motors hot</source>
        <translation>Motoren heiß</translation>
    </message>
    <message>
        <source>force switched off</source>
        <translation>Kraft abgeschaltet</translation>
    </message>
    <message>
        <source>not understood</source>
        <translation>nicht verstanden</translation>
    </message>
    <message>
        <source>key %1 only</source>
        <translation>nur Taste %1</translation>
    </message>
    <message>
        <source>button %1</source>
        <translation>Knopf %1</translation>
    </message>
    <message>
        <source>button %1 (second device: %2)</source>
        <translation>Knopf %1 (zweites Gerät: %2)</translation>
    </message>
    <message>
        <source>Set up…</source>
        <translation>Einrichten…</translation>
    </message>
    <message>
        <source>Follow the camera</source>
        <translation>Der Kamera folgen</translation>
    </message>
    <message>
        <source>Force only while held</source>
        <translation>Kraft nur, solange gehalten</translation>
    </message>
    <message>
        <source>Allow stiffness that may shake</source>
        <translation>Steifigkeit erlauben, die zittern kann</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>The motors may push from now on: hold the handle. Escape, Space in the 3-D view and the stop button take the force away.</source>
        <translation>Die Motoren können ab jetzt drücken: Halten Sie den Griff. Esc, die Leertaste in der 3-D-Ansicht und der Stoppknopf nehmen die Kraft weg.</translation>
    </message>
    <message>
        <source>State of the force</source>
        <translation>Zustand der Kraft</translation>
    </message>
    <message>
        <source>Haptic devices</source>
        <translation>Haptische Geräte</translation>
    </message>
    <message>
        <source>All known devices; those that are present come first</source>
        <translation>Alle bekannten Geräte; die vorhandenen stehen vorn</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Its maker&apos;s firmware file</source>
        <translation>Die Firmwaredatei seines Herstellers</translation>
    </message>
    <message>
        <source>Firmware file</source>
        <translation>Firmwaredatei</translation>
    </message>
    <message>
        <source>Looks for the firmware file</source>
        <translation>Sucht die Firmwaredatei</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen…</translation>
    </message>
    <message>
        <source>The device that turns the tool, where this one has no rotation</source>
        <translation>Das Gerät, das das Werkzeug dreht, wo dieses keine Drehung hat</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Connects the chosen device, without a force, or disconnects it</source>
        <translation>Verbindet das gewählte Gerät, ohne Kraft, oder trennt es</translation>
    </message>
    <message>
        <source>Look again</source>
        <translation>Neu suchen</translation>
    </message>
    <message>
        <source>Looks for devices that were plugged in meanwhile</source>
        <translation>Sucht Geräte, die inzwischen angeschlossen wurden</translation>
    </message>
    <message>
        <source>Right, up and towards you are the picture&apos;s; without it they stay as they are now.</source>
        <translation>Rechts, oben und zu Ihnen hin sind die des Bildes; ohne dies bleiben sie, wie sie jetzt sind.</translation>
    </message>
    <message>
        <source>Force only while this button, or %1 in the 3-D view, is held down</source>
        <translation>Kraft nur, solange dieser Knopf oder %1 in der 3-D-Ansicht gedrückt ist</translation>
    </message>
    <message>
        <source>While this button, or %1 in the 3-D view, is held, the tool stays and the hand moves</source>
        <translation>Solange dieser Knopf oder %1 in der 3-D-Ansicht gehalten ist, bleibt das Werkzeug stehen, und die Hand bewegt sich</translation>
    </message>
    <message>
        <source>The button that is held for a force, beside %1 in the 3-D view</source>
        <translation>Der Knopf, der für eine Kraft gehalten wird, neben %1 in der 3-D-Ansicht</translation>
    </message>
    <message>
        <source>Millimetres of the tool for a millimetre of the hand</source>
        <translation>Millimeter des Werkzeugs für einen Millimeter der Hand</translation>
    </message>
    <message>
        <source>The device may shake, hard and at once: hold it firmly, and keep Escape in reach.</source>
        <translation>Das Gerät kann zittern, heftig und sofort: Halten Sie es fest, und bleiben Sie in Reichweite von Esc.</translation>
    </message>
    <message>
        <source>Newtons at the hand for a newton in the scan</source>
        <translation>Newton an der Hand für ein Newton in der Aufnahme</translation>
    </message>
    <message>
        <source>From the hand to the scan</source>
        <translation>Von der Hand zur Aufnahme</translation>
    </message>
    <message>
        <source>Motion scale</source>
        <translation>Bewegungsmaßstab</translation>
    </message>
    <message>
        <source>Force scale</source>
        <translation>Kraftmaßstab</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Clutch</source>
        <translation>Kupplung</translation>
    </message>
    <message>
        <source>Held by</source>
        <translation>Halten mit</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <comment>a device and its place</comment>
        <translation>%1 an %2</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>held as it is</source>
        <translation>bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>Firmware of the device</source>
        <translation>Firmware des Geräts</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Connecting %1…</source>
        <translation>%1 wird verbunden…</translation>
    </message>
    <message>
        <source>1 mm of the hand is %1 mm in the scan.</source>
        <translation>1 mm der Hand ist %1 mm in der Aufnahme.</translation>
    </message>
    <message>
        <source>%1 N/m at the hand
%2 N/m in the scan</source>
        <translation>%1 N/m an der Hand
%2 N/m in der Aufnahme</translation>
    </message>
    <message>
        <source>No more is allowed to this device: %1 N/m at the hand were asked for.</source>
        <translation>Mehr ist diesem Gerät nicht erlaubt: Verlangt waren %1 N/m an der Hand.</translation>
    </message>
    <message>
        <source>No device</source>
        <translation>Kein Gerät</translation>
    </message>
    <message>
        <source>It moves the tool; nothing is felt.</source>
        <translation>Es bewegt das Werkzeug; zu fühlen ist nichts.</translation>
    </message>
    <message>
        <source>The stiffness is lowered to %1 % for now: the hand and the device shook.</source>
        <translation>Die Steifigkeit ist vorerst auf %1 % gesenkt: Hand und Gerät zitterten.</translation>
    </message>
    <message>
        <source>disconnected</source>
        <translation>getrennt</translation>
    </message>
    <message>
        <source>Still connecting. Firmware takes a minute. If nothing happens, press Cancel, unplug the device, plug it in, and retry. If that does not help, restart Palpate.</source>
        <translation>Noch wird verbunden. Firmware braucht eine Minute. Wenn nichts geschieht, drücken Sie Abbrechen, ziehen Sie das Gerät ab, stecken Sie es wieder an, und versuchen Sie es noch einmal. Wenn das nicht hilft, starten Sie Palpate neu.</translation>
    </message>
    <message>
        <source>The maker&apos;s firmware, which starts this device</source>
        <translation>Die Firmware des Herstellers, die dieses Gerät startet</translation>
    </message>
    <message>
        <source>Cables, permission, first use and troubleshooting</source>
        <translation>Kabel, Rechte, erster Gebrauch und Fehlersuche</translation>
    </message>
    <message>
        <source>Up to the device&apos;s rated stiffness. Without it, a stiffness at which the device and a light hand may shake each other cannot be set.</source>
        <translation>Bis zum Nennwert des Geräts. Ohne dies lässt sich keine Steifigkeit einstellen, bei der das Gerät und eine leichte Hand einander zum Zittern bringen können.</translation>
    </message>
    <message>
        <source>While this button, or %1 in the 3-D view, is held, the burr turns and cuts</source>
        <translation>Solange diese Taste oder %1 in der 3-D-Ansicht gehalten wird, dreht sich der Bohrer und schneidet</translation>
    </message>
    <message>
        <source>Burr</source>
        <translation>Bohrer</translation>
    </message>
</context>
<context>
    <name>ui::HelpPage</name>
    <message>
        <source>Page of the help</source>
        <translation>Seite der Hilfe</translation>
    </message>
    <message>
        <source>The arrow keys move through the page, Tab selects the next link</source>
        <translation>Die Pfeiltasten bewegen die Seite, Tab wählt den nächsten Verweis</translation>
    </message>
    <message>
        <source>This page is in English only.</source>
        <translation>Diese Seite gibt es nur auf Englisch.</translation>
    </message>
</context>
<context>
    <name>ui::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>The page before (Alt+Left)</source>
        <translation>Die vorige Seite (Alt+Links)</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>The page after (Alt+Right)</source>
        <translation>Die nächste Seite (Alt+Rechts)</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suche</translation>
    </message>
    <message>
        <source>Words to look for in all pages</source>
        <translation>Wörter, die auf allen Seiten gesucht werden</translation>
    </message>
    <message>
        <source>Contents of the help</source>
        <translation>Inhalt der Hilfe</translation>
    </message>
    <message>
        <source>The pages of the help</source>
        <translation>Die Seiten der Hilfe</translation>
    </message>
    <message>
        <source>Lists the pages that have all these words; Enter shows the next place</source>
        <translation>Listet die Seiten auf, die alle diese Wörter haben; Eingabe zeigt die nächste Stelle</translation>
    </message>
</context>
<context>
    <name>ui::HistogramSlider</name>
    <message>
        <source>Drag, or press the arrow keys; with Shift in small steps</source>
        <translation>Ziehen, oder die Pfeiltasten drücken; mit Umschalt in kleinen Schritten</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>No scan yet</source>
        <translation>Noch keine Aufnahme</translation>
    </message>
</context>
<context>
    <name>ui::IsosurfacePanel</name>
    <message>
        <source>Isovalue</source>
        <translation>Isowert</translation>
    </message>
    <message>
        <source>Isovalue, typed</source>
        <translation>Isowert, eingetippt</translation>
    </message>
    <message>
        <source>The isovalue must lie above the volume&apos;s least value, %L1.</source>
        <translation>Der Isowert muss über dem kleinsten Wert des Volumens liegen, %L1.</translation>
    </message>
    <message>
        <source>Nothing in this volume is above %L1.</source>
        <translation>Nichts in diesem Volumen liegt über %L1.</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Airway</source>
        <translation>Atemwege</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Zähne</translation>
    </message>
    <message>
        <source>The intensity of the surface that is seen and felt, from %L1 to %L2 %3</source>
        <translation>Der Wert der Fläche, die man sieht und fühlt, von %L1 bis %L2 %3</translation>
    </message>
    <message>
        <source>%L1 %2: a starting point, not a threshold for diagnosis</source>
        <translation>%L1 %2: ein Ausgangspunkt, keine Schwelle für die Diagnose</translation>
    </message>
</context>
<context>
    <name>ui::KeyButton</name>
    <message>
        <source>Press the key…</source>
        <translation>Taste drücken…</translation>
    </message>
    <message>
        <source>&amp;Change…</source>
        <translation>&amp;Ändern…</translation>
    </message>
    <message>
        <source>Takes another key for the chosen line: the next that is pressed</source>
        <translation>Nimmt eine andere Taste für die gewählte Zeile: die nächste, die gedrückt wird</translation>
    </message>
    <message>
        <source>Press the new key, or Escape to cancel</source>
        <translation>Drücken Sie die neue Taste oder Esc zum Abbrechen</translation>
    </message>
</context>
<context>
    <name>ui::Lasso</name>
    <message>
        <source>%1: cuts what is hatched. Escape: keeps it. Drag: draws another outline.</source>
        <translation>%1: schneidet das Schraffierte. Escape: behält es. Ziehen: zeichnet einen anderen Umriss.</translation>
    </message>
    <message>
        <source>Drag: draws the outline of a cut. Or click, or %1 at the crosshair: sets a corner; at the last one again: closes it. %2: takes it back.</source>
        <translation>Ziehen: zeichnet den Umriss eines Schnitts. Oder ein Klick, oder %1 am Fadenkreuz: setzt eine Ecke; an der letzten noch einmal: schließt ihn. %2: nimmt sie zurück.</translation>
    </message>
</context>
<context>
    <name>ui::LoadPlot</name>
    <message>
        <source>Tick time over number of points</source>
        <translation>Taktzeit über der Zahl der Punkte</translation>
    </message>
    <message>
        <source>budget %1 ms</source>
        <translation>Budget %1 ms</translation>
    </message>
    <message>
        <source>%1 points: median %2, 99 % within %3, longest %4 ms</source>
        <translation>%1 Punkte: Median %2, 99 % unter %3, längster %4 ms</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>Tick, ms: 99 %, and median to longest</source>
        <translation>Takt, ms: 99 %, und Median bis längster</translation>
    </message>
    <message>
        <source>◆ present tool</source>
        <translation>◆ jetziges Werkzeug</translation>
    </message>
    <message>
        <source>● carried  × too many</source>
        <translation>● getragen  × zu viele</translation>
    </message>
</context>
<context>
    <name>ui::Loading</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancels the loading or the computation</source>
        <translation>Bricht das Laden oder die Berechnung ab</translation>
    </message>
</context>
<context>
    <name>ui::MainWindow</name>
    <message>
        <source>Force stopped by Escape</source>
        <translation>Kraft mit Esc angehalten</translation>
    </message>
    <message>
        <source>Force stopped by Space</source>
        <translation>Kraft mit der Leertaste angehalten</translation>
    </message>
    <message>
        <source>Mesh: %1</source>
        <translation>Gitternetz: %1</translation>
    </message>
    <message>
        <source>Open a scan</source>
        <translation>Eine Aufnahme öffnen</translation>
    </message>
    <message>
        <source>Choose the surface</source>
        <translation>Die Oberfläche wählen</translation>
    </message>
    <message>
        <source>Touch it</source>
        <translation>Berühren</translation>
    </message>
    <message>
        <source>Press %1 and the mouse holds the tool, or drag the tool itself. The tool stops at the surface, and the card shows the force. Escape stops the force at any time.</source>
        <translation>Drücken Sie %1, und die Maus hält das Werkzeug, oder ziehen Sie das Werkzeug selbst. Es bleibt an der Oberfläche stehen, und die Karte zeigt die Kraft. Esc hält die Kraft jederzeit an.</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Figures of the servo loop: rate, time of a tick, late ticks</source>
        <translation>Zahlen der Regelschleife: Rate, Zeit eines Takts, verspätete Takte</translation>
    </message>
    <message>
        <source>%1 (edited)</source>
        <translation>%1 (bearbeitet)</translation>
    </message>
    <message>
        <source>%1 — Palpate</source>
        <translation>%1 — Palpate</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 voxels · %L4 × %L5 × %L6 mm</source>
        <translation>%1 × %2 × %3 Voxel · %L4 × %L5 × %L6 mm</translation>
    </message>
    <message>
        <source>Drag the line: the surface is where the scan has this value. Picture and touch change at once.</source>
        <translation>Ziehen Sie die Linie: Die Oberfläche liegt dort, wo die Aufnahme diesen Wert hat. Bild und Tastgefühl ändern sich sofort.</translation>
    </message>
    <message>
        <source>The dropped item is not on this machine&apos;s disks; copy it there first.</source>
        <translation>Das abgelegte Objekt ist nicht auf den Datenträgern dieses Rechners; kopieren Sie es zuerst dorthin.</translation>
    </message>
    <message>
        <source>Here, with File &gt; Open file, or by dropping it on the window. Left and right come from the file.</source>
        <translation>Hier, mit Datei &gt; Datei öffnen, oder indem Sie sie auf dem Fenster ablegen. Links und rechts kommen aus der Datei.</translation>
    </message>
    <message>
        <source>Not a medical device. Not for treatment.</source>
        <translation>Kein Medizinprodukt. Nicht für die Behandlung.</translation>
    </message>
</context>
<context>
    <name>ui::MarksPanel</name>
    <message>
        <source>&amp;Go to</source>
        <translation>&amp;Hingehen</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>&amp;Undo delete</source>
        <translation>Löschen &amp;zurücknehmen</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Half a voxel diagonal for each place. Errors of the scanner and of the choice of the places are not in it.</source>
        <translation>Für jede Stelle eine halbe Diagonale eines Voxels. Fehler des Scanners und der Wahl der Stellen sind nicht darin.</translation>
    </message>
    <message>
        <source>Press at the two ends, or drag from one to the other</source>
        <translation>An den beiden Enden drücken, oder von einem zum anderen ziehen</translation>
    </message>
    <message>
        <source>Press at the end of one leg, at the corner, and at the end of the other leg</source>
        <translation>Am Ende des einen Schenkels, am Scheitel und am Ende des anderen Schenkels drücken</translation>
    </message>
    <message>
        <source>Press where the note belongs, then type it</source>
        <translation>Dort drücken, wo die Notiz hingehört, dann tippen</translation>
    </message>
    <message>
        <source>%1 (key %2 in a view)</source>
        <translation>%1 (Taste %2 in einer Ansicht)</translation>
    </message>
    <message>
        <source>Measures, marks and notes</source>
        <translation>Maße, Markierungen und Notizen</translation>
    </message>
    <message>
        <source>Name or note</source>
        <translation>Name oder Notiz</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>No measures or marks yet: choose one above, then click in a view</source>
        <translation>Noch keine Maße oder Markierungen: Wählen Sie oben eine Art, dann klicken Sie in eine Ansicht</translation>
    </message>
    <message>
        <source>Moves the crosshair to the place; again, to its next place</source>
        <translation>Bringt das Fadenkreuz zur Stelle; noch einmal: zur nächsten</translation>
    </message>
    <message>
        <source>Renames the mark, or edits the note</source>
        <translation>Benennt die Markierung um, oder ändert die Notiz</translation>
    </message>
    <message>
        <source>Deletes the mark</source>
        <translation>Löscht die Markierung</translation>
    </message>
    <message>
        <source>Brings back the mark that was deleted last</source>
        <translation>Bringt die zuletzt gelöschte Markierung zurück</translation>
    </message>
    <message>
        <source>Measures the way of the tool from where it is now</source>
        <translation>Misst den Weg des Werkzeugs von dort, wo es jetzt ist</translation>
    </message>
    <message>
        <source>Ends the measurement of the way</source>
        <translation>Beendet die Messung des Weges</translation>
    </message>
    <message>
        <source>The tool&apos;s way is not measured.</source>
        <translation>Der Weg des Werkzeugs wird nicht gemessen.</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Start at the tool</source>
        <translation>Am Werkzeug beginnen</translation>
    </message>
    <message>
        <source>Press at the place to read</source>
        <translation>Drücken Sie an der Stelle, die gelesen werden soll</translation>
    </message>
    <message>
        <source>%1 shows the place, %2 renames, %3 deletes</source>
        <translation>%1 zeigt die Stelle, %2 benennt um, %3 löscht</translation>
    </message>
    <message>
        <source>± is the accuracy that the voxels allow.</source>
        <translation>± ist die Genauigkeit, die die Voxel erlauben.</translation>
    </message>
</context>
<context>
    <name>ui::Measure</name>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>unknown: the legs are too short</source>
        <translation>unbekannt: Die Schenkel sind zu kurz</translation>
    </message>
    <message>
        <source>outside the scan</source>
        <translation>außerhalb der Aufnahme</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
</context>
<context>
    <name>ui::Measures</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Travelled %1</source>
        <translation>Gefahren %1</translation>
    </message>
    <message>
        <source>Not for treatment</source>
        <translation>Nicht zur Behandlung</translation>
    </message>
    <message>
        <source>Click, or %1 at the crosshair: sets a place. %2: takes it back. Escape: ends.</source>
        <translation>Klicken, oder %1 am Fadenkreuz: setzt eine Stelle. %2: nimmt sie zurück. Esc: beendet.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
</context>
<context>
    <name>ui::Menus</name>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>&amp;Open file…</source>
        <translation>Datei ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open a scan</source>
        <translation>Eine Aufnahme öffnen</translation>
    </message>
    <message>
        <source>Opens a scan in a file</source>
        <translation>Öffnet eine Aufnahme in einer Datei</translation>
    </message>
    <message>
        <source>Open &amp;folder…</source>
        <translation>&amp;Ordner öffnen…</translation>
    </message>
    <message>
        <source>Open a folder of slices</source>
        <translation>Einen Ordner mit Schichten öffnen</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Open &amp;phantom</source>
        <translation>P&amp;hantom öffnen</translation>
    </message>
    <message>
        <source>Open recor&amp;ding…</source>
        <translation>&amp;Aufzeichnung öffnen…</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>Eine Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Recordings (*.palpate)</source>
        <translation>Aufzeichnungen (*.palpate)</translation>
    </message>
    <message>
        <source>Open &amp;view…</source>
        <translation>A&amp;nsicht öffnen…</translation>
    </message>
    <message>
        <source>Open a view</source>
        <translation>Eine Ansicht öffnen</translation>
    </message>
    <message>
        <source>Views (*.palpate-view)</source>
        <translation>Ansichten (*.palpate-view)</translation>
    </message>
    <message>
        <source>Save view &amp;as…</source>
        <translation>Ansicht speichern &amp;unter…</translation>
    </message>
    <message>
        <source>&amp;Series of this folder…</source>
        <translation>&amp;Serien dieses Ordners…</translation>
    </message>
    <message>
        <source>Save &amp;edited volume as…</source>
        <translation>Bearbeitetes &amp;Volumen speichern unter…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Layout</source>
        <translation>Anordn&amp;ung</translation>
    </message>
    <message>
        <source>T&amp;heme</source>
        <translation>F&amp;arbschema</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>Anordnung zu&amp;rücksetzen</translation>
    </message>
    <message>
        <source>Hi&amp;nts</source>
        <translation>Hin&amp;weise</translation>
    </message>
    <message>
        <source>Layout of the views</source>
        <translation>Anordnung der Ansichten</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Controls</source>
        <translation>&amp;Bedienung</translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation>&amp;Erste Schritte</translation>
    </message>
    <message>
        <source>Show &amp;log</source>
        <translation>&amp;Protokoll anzeigen</translation>
    </message>
    <message>
        <source>&amp;About Palpate</source>
        <translation>Übe&amp;r Palpate</translation>
    </message>
    <message>
        <source>&amp;One view</source>
        <translation>&amp;Eine Ansicht</translation>
    </message>
    <message>
        <source>&amp;Two by two</source>
        <translation>&amp;Zwei mal zwei</translation>
    </message>
    <message>
        <source>&amp;3-D large</source>
        <translation>&amp;3-D groß</translation>
    </message>
    <message>
        <source>&amp;Slices large</source>
        <translation>&amp;Schnittbilder groß</translation>
    </message>
    <message>
        <source>&amp;First sizes</source>
        <translation>&amp;Anfangsgrößen</translation>
    </message>
    <message>
        <source>View &amp;alone, or all</source>
        <translation>Ansicht a&amp;llein oder alle</translation>
    </message>
    <message>
        <source>&amp;Next view</source>
        <translation>&amp;Nächste Ansicht</translation>
    </message>
    <message>
        <source>Pre&amp;ferences…</source>
        <translation>&amp;Einstellungen…</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>Wie der &amp;Desktop</translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation>D&amp;unkel</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>Hoher &amp;Kontrast</translation>
    </message>
    <message>
        <source>Save edited volume as</source>
        <translation>Bearbeitetes Volumen speichern unter</translation>
    </message>
    <message>
        <source>NRRD (*.nrrd)</source>
        <translation>NRRD (*.nrrd)</translation>
    </message>
    <message>
        <source>&amp;Remember recent places</source>
        <translation>Letzte Orte &amp;merken</translation>
    </message>
    <message>
        <source>&amp;Forget recent places</source>
        <translation>Letzte Orte &amp;vergessen</translation>
    </message>
    <message>
        <source>Controls</source>
        <translation>Bedienung</translation>
    </message>
    <message>
        <source>About Palpate</source>
        <translation>Über Palpate</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;Palpate %1&lt;/b&gt;&lt;/p&gt;&lt;p&gt;See a CT scan, and feel it through a haptic device.&lt;/p&gt;&lt;p&gt;&lt;b&gt;%2&lt;/b&gt;&lt;/p&gt;&lt;p&gt;BSD-3-Clause licence. Palpate uses Qt (LGPL-3), VTK, vtk-dicom, Eigen, HDF5, DCMTK, CharLS, OpenJPEG, libarchive, libdeflate, hidapi and libusb (LGPL-2.1), libseccomp (LGPL-2.1), elfutils (LGPL-3), SQLite and others, as Debian packages them. The help lists all of them, with their licences.&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;b&gt;Palpate %1&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Eine CT-Aufnahme sehen und mit einem haptischen Gerät ertasten.&lt;/p&gt;&lt;p&gt;&lt;b&gt;%2&lt;/b&gt;&lt;/p&gt;&lt;p&gt;Lizenz BSD-3-Clause. Palpate verwendet Qt (LGPL-3), VTK, vtk-dicom, Eigen, HDF5, DCMTK, CharLS, OpenJPEG, libarchive, libdeflate, hidapi und libusb (LGPL-2.1), libseccomp (LGPL-2.1), elfutils (LGPL-3), SQLite und andere, wie Debian sie verpackt. Die Hilfe führt alle auf, mit ihren Lizenzen.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;Force off&lt;/b&gt;: Escape anywhere, Space in the 3-D view, or the stop button. Without motors the first Escape closes what is open.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Haptic device&lt;/b&gt; (View &gt; Haptic device): Connect, then Arm. While %1 is held in the 3-D view the tool stays and the hand moves freely; with hold-to-run, the force is on while %2 is held.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Mouse&lt;/b&gt;: it turns the picture until you take the tool (%3, or the button), and then moves the tool. The tool itself can be dragged at any time.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Measures&lt;/b&gt;: click where the places are, or drag a distance. Handles can be dragged in every view.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Slices&lt;/b&gt;: a right click, the key %4 or the button in the corner opens the choices: windows, slabs, contour, following the tool, the view down the tool.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Replay&lt;/b&gt;: on its bar, ▼ are marks, ◆ settings, ■ scene and camera, ● force and device, × samples lost and ticks late.&lt;/p&gt;&lt;p&gt;Keys can be changed: Edit &gt; Preferences, Shortcuts.&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;b&gt;Kraft aus&lt;/b&gt;: Esc überall, die Leertaste in der 3-D-Ansicht oder der Stoppknopf. Ohne Motoren schließt das erste Esc, was offen ist.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Haptisches Gerät&lt;/b&gt; (Ansicht &gt; Haptisches Gerät): Verbinden, dann Freigeben. Solange %1 in der 3-D-Ansicht gehalten wird, bleibt das Werkzeug stehen, und die Hand bewegt sich frei; mit Zustimmtaste ist die Kraft ein, solange %2 gehalten wird.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Maus&lt;/b&gt;: Sie dreht das Bild, bis Sie das Werkzeug nehmen (%3 oder der Knopf), und bewegt dann das Werkzeug. Das Werkzeug selbst lässt sich jederzeit ziehen.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Maße&lt;/b&gt;: Klicken Sie auf die Stellen, oder ziehen Sie einen Abstand. Griffe lassen sich in jeder Ansicht ziehen.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Schnittbilder&lt;/b&gt;: Ein Rechtsklick, die Taste %4 oder der Knopf in der Ecke öffnet die Auswahl: Fensterung, Slabs, Kontur, dem Werkzeug folgen, der Blick entlang des Werkzeugs.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Wiedergabe&lt;/b&gt;: Auf ihrer Leiste sind ▼ Marken, ◆ Einstellungen, ■ Szene und Kamera, ● Kraft und Gerät, × verlorene Abtastwerte und verspätete Takte.&lt;/p&gt;&lt;p&gt;Tasten lassen sich ändern: Bearbeiten &gt; Einstellungen, Tastenkürzel.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Opens a folder of slices</source>
        <translation>Öffnet einen Ordner mit Schichten</translation>
    </message>
    <message>
        <source>From PA&amp;CS…</source>
        <translation>Aus &amp;PACS…</translation>
    </message>
    <message>
        <source>E&amp;xport recording…</source>
        <translation>Aufzeichnung e&amp;xportieren…</translation>
    </message>
    <message>
        <source>Save vie&amp;w</source>
        <translation>Ans&amp;icht speichern</translation>
    </message>
    <message>
        <source>Export s&amp;urface…</source>
        <translation>Oberf&amp;läche exportieren…</translation>
    </message>
    <message>
        <source>&amp;Drawing of the surface</source>
        <translation>Zeichnen der &amp;Oberfläche</translation>
    </message>
    <message>
        <source>&amp;Automatic</source>
        <translation>&amp;Automatisch</translation>
    </message>
    <message>
        <source>&amp;Ray casting</source>
        <translation>&amp;Raycasting</translation>
    </message>
    <message>
        <source>&amp;Mesh</source>
        <translation>&amp;Gitternetz</translation>
    </message>
    <message>
        <source>Open s&amp;tructures…</source>
        <translation>S&amp;trukturen öffnen…</translation>
    </message>
    <message>
        <source>Open structures of the scan on view</source>
        <translation>Strukturen der gezeigten Aufnahme öffnen</translation>
    </message>
    <message>
        <source>&amp;Try structures</source>
        <translation>&amp;Strukturen ausprobieren</translation>
    </message>
</context>
<context>
    <name>ui::Messages</name>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Shows the cause and the remedy in the help</source>
        <translation>Zeigt in der Hilfe die Ursache und die Abhilfe</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Please confirm</source>
        <translation>Bitte bestätigen</translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation>Nicht gespeichert</translation>
    </message>
    <message>
        <source>&amp;Save view…</source>
        <translation>Ansicht &amp;speichern…</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>Not a medical device. Not for diagnosis. Force feedback hardware can move suddenly.</source>
        <translation>Kein Medizinprodukt. Nicht zur Diagnose. Geräte mit Kraftrückkopplung können sich plötzlich bewegen.</translation>
    </message>
    <message>
        <source>Before you begin</source>
        <translation>Bevor Sie beginnen</translation>
    </message>
    <message>
        <source>Keep hands and face clear of a device until it is at rest. Escape takes the force away at any time.</source>
        <translation>Halten Sie Hände und Gesicht von einem Gerät fern, bis es ruht. Esc nimmt die Kraft jederzeit weg.</translation>
    </message>
    <message>
        <source>Not finished</source>
        <translation>Nicht fertig</translation>
    </message>
    <message>
        <source>A file is still being written.</source>
        <translation>Eine Datei wird noch geschrieben.</translation>
    </message>
    <message>
        <source>The window can close while it is finished in the background. If it is stopped, no file remains.</source>
        <translation>Das Fenster kann schließen, während sie im Hintergrund fertig wird. Wird sie angehalten, bleibt keine Datei.</translation>
    </message>
    <message>
        <source>&amp;Finish in the background</source>
        <translation>Im &amp;Hintergrund fertigstellen</translation>
    </message>
    <message>
        <source>&amp;Stop it</source>
        <translation>&amp;Anhalten</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is there already.</source>
        <translation>„%1“ gibt es schon.</translation>
    </message>
    <message>
        <source>It is written over.</source>
        <translation>Die Datei wird überschrieben.</translation>
    </message>
    <message>
        <source>Write over it</source>
        <translation>Überschreiben</translation>
    </message>
    <message>
        <source>Structures, or a scan</source>
        <translation>Strukturen oder eine Aufnahme</translation>
    </message>
    <message>
        <source>&quot;%1&quot; has the same voxels as the scan on view.</source>
        <translation>„%1“ hat dieselben Voxel wie die gezeigte Aufnahme.</translation>
    </message>
    <message>
        <source>Structures are shown in the scan on view. A scan takes its place.</source>
        <translation>Strukturen werden in der gezeigten Aufnahme angezeigt. Eine Aufnahme tritt an ihre Stelle.</translation>
    </message>
    <message>
        <source>Show s&amp;tructures</source>
        <translation>S&amp;trukturen zeigen</translation>
    </message>
    <message>
        <source>&amp;Open as a scan</source>
        <translation>Als Aufnahme ö&amp;ffnen</translation>
    </message>
    <message>
        <source>Left or right</source>
        <translation>Links oder rechts</translation>
    </message>
    <message>
        <source>The program that wrote the file knows. A wrong answer mirrors the structure.</source>
        <translation>Das Programm, das die Datei geschrieben hat, weiß es. Eine falsche Antwort spiegelt die Struktur.</translation>
    </message>
    <message>
        <source>x points to the &amp;left (LPS)</source>
        <translation>x zeigt nach &amp;links (LPS)</translation>
    </message>
    <message>
        <source>x points to the &amp;right (RAS)</source>
        <translation>x zeigt nach &amp;rechts (RAS)</translation>
    </message>
</context>
<context>
    <name>ui::NearnessLines</name>
    <message>
        <source>close</source>
        <translation>sehr nah</translation>
    </message>
    <message>
        <source>near</source>
        <translation>nah</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>innen</translation>
    </message>
    <message>
        <source>over %1 mm</source>
        <translation>über %1 mm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Distance to %1</source>
        <translation>Abstand zu %1</translation>
    </message>
</context>
<context>
    <name>ui::NumberBox</name>
    <message>
        <source>Energy that a cubic millimetre takes</source>
        <translation>Energie, die ein Kubikmillimeter braucht</translation>
    </message>
    <message>
        <source> J/mm³</source>
        <translation> J/mm³</translation>
    </message>
</context>
<context>
    <name>ui::PacsServerDialog</name>
    <message>
        <source>Server</source>
        <translation>Server</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>DICOMweb</source>
        <translation>DICOMweb</translation>
    </message>
    <message>
        <source>DIMSE (C-FIND, C-GET)</source>
        <translation>DIMSE (C-FIND, C-GET)</translation>
    </message>
    <message>
        <source>&amp;Protocol</source>
        <translation>&amp;Protokoll</translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation>&amp;Adresse</translation>
    </message>
    <message>
        <source>The URL that ends before /studies</source>
        <translation>Die URL, die vor /studies endet</translation>
    </message>
    <message>
        <source>&amp;Host</source>
        <translation>&amp;Host</translation>
    </message>
    <message>
        <source>Name or address of the server</source>
        <translation>Name oder Adresse des Servers</translation>
    </message>
    <message>
        <source>The server&apos;s port, often 104 or 11112</source>
        <translation>Der Port des Servers, oft 104 oder 11112</translation>
    </message>
    <message>
        <source>P&amp;ort</source>
        <translation>P&amp;ort</translation>
    </message>
    <message>
        <source>AE title of the &amp;server</source>
        <translation>AE-Titel des &amp;Servers</translation>
    </message>
    <message>
        <source>As its administrator has named it</source>
        <translation>Wie ihn der Administrator genannt hat</translation>
    </message>
    <message>
        <source>AE title of &amp;Palpate</source>
        <translation>AE-Titel von Palpat&amp;e</translation>
    </message>
    <message>
        <source>The server must know this title and this computer</source>
        <translation>Der Server muss diesen Titel und diesen Computer kennen</translation>
    </message>
    <message>
        <source>&amp;TLS</source>
        <translation>&amp;TLS</translation>
    </message>
    <message>
        <source>Encrypts the connection and checks the server&apos;s certificate</source>
        <translation>Verschlüsselt die Verbindung und prüft das Zertifikat des Servers</translation>
    </message>
    <message>
        <source>Fetch by C-&amp;MOVE, at</source>
        <translation>Mit C-&amp;MOVE holen, bei</translation>
    </message>
    <message>
        <source>For servers without C-GET. During a transfer, this computer then takes a connection from the server at this address</source>
        <translation>Für Server ohne C-GET. Während einer Übertragung nimmt dieser Computer dann unter dieser Adresse eine Verbindung vom Server an</translation>
    </message>
    <message>
        <source>Address and port for C-MOVE</source>
        <translation>Adresse und Port für C-MOVE</translation>
    </message>
    <message>
        <source>Address and port at which the server reaches this computer</source>
        <translation>Adresse und Port, unter denen der Server diesen Computer erreicht</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>user and password, asked each time</source>
        <translation>Benutzer und Passwort, jedes Mal gefragt</translation>
    </message>
    <message>
        <source>token, asked each time</source>
        <translation>Token, jedes Mal gefragt</translation>
    </message>
    <message>
        <source>from the desktop&apos;s keyring</source>
        <translation>aus dem Schlüsselbund des Desktops</translation>
    </message>
    <message>
        <source>&amp;Login</source>
        <translation>Anmel&amp;dung</translation>
    </message>
    <message>
        <source>&amp;User</source>
        <translation>&amp;Benutzer</translation>
    </message>
    <message>
        <source>The user&apos;s name at the server</source>
        <translation>Der Name des Benutzers beim Server</translation>
    </message>
    <message>
        <source>&amp;Trusted certificates</source>
        <translation>&amp;Vertraute Zertifikate</translation>
    </message>
    <message>
        <source>Certificates (PEM) that are trusted beside the system&apos;s</source>
        <translation>Zertifikate (PEM), denen neben denen des Systems vertraut wird</translation>
    </message>
    <message>
        <source>Own &amp;certificate</source>
        <translation>Eigenes &amp;Zertifikat</translation>
    </message>
    <message>
        <source>Its private &amp;key</source>
        <translation>Sein privater Schlüsse&amp;l</translation>
    </message>
    <message>
        <source>Private key (PEM) of that certificate</source>
        <translation>Privater Schlüssel (PEM) dieses Zertifikats</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>Chooses a file</source>
        <translation>Wählt eine Datei</translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation>Wählen: %1</translation>
    </message>
    <message>
        <source>Your name for the server</source>
        <translation>Ihr Name für den Server</translation>
    </message>
    <message>
        <source>Protocol of the server; DICOMweb if the server has it</source>
        <translation>Protokoll des Servers; DICOMweb, wenn der Server es hat</translation>
    </message>
    <message>
        <source>Sign-in at the server; Palpate stores no password</source>
        <translation>Anmeldung am Server; Palpate speichert kein Passwort</translation>
    </message>
    <message>
        <source>Certificate (PEM) of this computer, if the server requires one</source>
        <translation>Zertifikat (PEM) dieses Computers, wenn der Server eines verlangt</translation>
    </message>
</context>
<context>
    <name>ui::PacsWindow</name>
    <message>
        <source>From PACS</source>
        <translation>Aus PACS</translation>
    </message>
    <message>
        <source>Server</source>
        <translation>Server</translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation>&amp;Hinzufügen…</translation>
    </message>
    <message>
        <source>Describes another server</source>
        <translation>Beschreibt einen weiteren Server</translation>
    </message>
    <message>
        <source>&amp;Edit…</source>
        <translation>&amp;Bearbeiten…</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Forgets the server</source>
        <translation>Vergisst den Server</translation>
    </message>
    <message>
        <source>&amp;Test</source>
        <translation>&amp;Testen</translation>
    </message>
    <message>
        <source>Password or token</source>
        <translation>Passwort oder Token</translation>
    </message>
    <message>
        <source>; * and ? stand for any letters</source>
        <translation>; * und ? stehen für beliebige Buchstaben</translation>
    </message>
    <message>
        <source>Patient&apos;s number</source>
        <translation>Nummer des Patienten</translation>
    </message>
    <message>
        <source>The number of the patient</source>
        <translation>Die Nummer des Patienten</translation>
    </message>
    <message>
        <source>Patient&apos;s name</source>
        <translation>Name des Patienten</translation>
    </message>
    <message>
        <source>FAMILY^GIVEN, as in the archive</source>
        <translation>NACHNAME^VORNAME, wie im Archiv</translation>
    </message>
    <message>
        <source>Accession number</source>
        <translation>Accession-Nummer</translation>
    </message>
    <message>
        <source>The number of the order</source>
        <translation>Die Nummer des Auftrags</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalität</translation>
    </message>
    <message>
        <source>CT</source>
        <translation>CT</translation>
    </message>
    <message>
        <source>MR</source>
        <translation>MR</translation>
    </message>
    <message>
        <source>any</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>&amp;Search</source>
        <translation>&amp;Suchen</translation>
    </message>
    <message>
        <source>Lists the series that match</source>
        <translation>Listet die passenden Serien auf</translation>
    </message>
    <message>
        <source>Show patients&apos; &amp;names</source>
        <translation>&amp;Namen der Patienten zeigen</translation>
    </message>
    <message>
        <source>Lists patients and descriptions too; searches again</source>
        <translation>Listet auch Patienten und Beschreibungen auf; sucht noch einmal</translation>
    </message>
    <message>
        <source>Patient&apos;s n&amp;umber</source>
        <translation>N&amp;ummer des Patienten</translation>
    </message>
    <message>
        <source>Patient&apos;s na&amp;me</source>
        <translation>Na&amp;me des Patienten</translation>
    </message>
    <message>
        <source>A&amp;ccession number</source>
        <translation>A&amp;ccession-Nummer</translation>
    </message>
    <message>
        <source>&amp;Date</source>
        <translation>&amp;Datum</translation>
    </message>
    <message>
        <source>M&amp;odality</source>
        <translation>M&amp;odalität</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Enter or a double-click fetches a series</source>
        <translation>Eingabe oder ein Doppelklick holt eine Serie</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Images</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Study&apos;s name</source>
        <translation>Name der Studie</translation>
    </message>
    <message>
        <source>Series&apos; name</source>
        <translation>Name der Serie</translation>
    </message>
    <message>
        <source>No series yet: choose a server, then search</source>
        <translation>Noch keine Serien: Wählen Sie einen Server, dann suchen Sie</translation>
    </message>
    <message>
        <source>&amp;Fetch and open</source>
        <translation>&amp;Holen und öffnen</translation>
    </message>
    <message>
        <source>Fetches the chosen series into a folder that is emptied in the end, and opens it</source>
        <translation>Holt die gewählte Serie in einen Ordner, der am Ende geleert wird, und öffnet sie</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Closes this window</source>
        <translation>Schließt dieses Fenster</translation>
    </message>
    <message>
        <source>Add the server of your archive first.</source>
        <translation>Fügen Sie zuerst den Server Ihres Archivs hinzu.</translation>
    </message>
    <message>
        <source>%1 of %2 images, %3</source>
        <translation>%1 von %2 Bildern, %3</translation>
    </message>
    <message>
        <source>%1 images, %2</source>
        <translation>%1 Bilder, %2</translation>
    </message>
    <message>
        <source>Token</source>
        <translation>Token</translation>
    </message>
    <message>
        <source>Password of %1</source>
        <translation>Passwort von %1</translation>
    </message>
    <message>
        <source>For the server; it is stored in no file of Palpate, and forgotten when the window closes</source>
        <translation>Für den Server; in keiner Datei von Palpate gespeichert und vergessen, wenn das Fenster schließt</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Behalten</translation>
    </message>
    <message>
        <source>Stores it in the desktop&apos;s keyring</source>
        <translation>Speichert es im Schlüsselbund des Desktops</translation>
    </message>
    <message>
        <source>For&amp;get</source>
        <translation>&amp;Vergessen</translation>
    </message>
    <message>
        <source>Removes it from the desktop&apos;s keyring</source>
        <translation>Entfernt es aus dem Schlüsselbund des Desktops</translation>
    </message>
    <message>
        <source>The archive to search</source>
        <translation>Das Archiv, das durchsucht wird</translation>
    </message>
    <message>
        <source>Changes the entries for the server</source>
        <translation>Ändert die Angaben zum Server</translation>
    </message>
    <message>
        <source>Tests the connection and names the fault</source>
        <translation>Prüft die Verbindung und nennt den Fehler</translation>
    </message>
    <message>
        <source>Kind of scan to search for</source>
        <translation>Art der gesuchten Aufnahme</translation>
    </message>
    <message>
        <source>Cancels the request to the server</source>
        <translation>Bricht die Anfrage an den Server ab</translation>
    </message>
    <message>
        <source>from the keyring</source>
        <translation>aus dem Schlüsselbund</translation>
    </message>
    <message>
        <source>A day, or the first and the last with a hyphen between them, either left out: %1</source>
        <translation>Ein Tag, oder der erste und der letzte mit einem Bindestrich dazwischen, von denen einer fehlen darf: %1</translation>
    </message>
</context>
<context>
    <name>ui::PerformancePanel</name>
    <message>
        <source>Left out</source>
        <translation>Weggelassen</translation>
    </message>
    <message>
        <source>How far the measurement is</source>
        <translation>Wie weit die Messung ist</translation>
    </message>
    <message>
        <source>&amp;Measure this machine</source>
        <translation>Diesen Rechner &amp;messen</translation>
    </message>
    <message>
        <source>Ten seconds with the present volume, tool and stiffness: how long a tick takes, and how many points this machine carries</source>
        <translation>Zehn Sekunden mit dem jetzigen Volumen, Werkzeug und der jetzigen Steifigkeit: wie lange ein Takt dauert und wie viele Punkte dieser Rechner trägt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Ends the measurement without a result</source>
        <translation>Beendet die Messung ohne Ergebnis</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;%1&lt;/b&gt;: %2&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;b&gt;%1&lt;/b&gt;: %2&lt;/p&gt;</translation>
    </message>
    <message>
        <source>no misses</source>
        <translation>keine ausgelassen</translation>
    </message>
    <message>
        <source>1 miss</source>
        <translation>1 ausgelassen</translation>
    </message>
    <message>
        <source>%1 misses</source>
        <translation>%1 ausgelassen</translation>
    </message>
    <message>
        <source>%1 points: longest tick %2 ms, %3</source>
        <translation>%1 Punkte: längster Takt %2 ms, %3</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>%1; not even %2 points, spread evenly, on this machine.</source>
        <translation>%1; nicht einmal %2 Punkte, gleichmäßig verteilt, auf diesem Rechner.</translation>
    </message>
    <message>
        <source>%1; %2 points and more on this machine.</source>
        <translation>%1; %2 Punkte und mehr auf diesem Rechner.</translation>
    </message>
    <message>
        <source>%1; up to %2 points on this machine.</source>
        <translation>%1; bis zu %2 Punkte auf diesem Rechner.</translation>
    </message>
    <message>
        <source>Half of the ticks took at most %1 ms, 99 in 100 at most %2 ms of CPU.</source>
        <translation>Die Hälfte der Takte brauchte höchstens %1 ms, 99 von 100 höchstens %2 ms CPU.</translation>
    </message>
    <message>
        <source>None of %1 was cut by the budget of %2 ms.</source>
        <translation>Keiner von %1 wurde vom Budget von %2 ms gekürzt.</translation>
    </message>
    <message>
        <source>less than 0.001</source>
        <translation>weniger als 0,001</translation>
    </message>
    <message>
        <source>That is more than this machine carries.</source>
        <translation>Das ist mehr, als dieser Rechner trägt.</translation>
    </message>
    <message>
        <source>Meanwhile, by the clock on the wall, the live loop began %1 of %2 ticks late and missed %3.</source>
        <translation>Inzwischen begann die laufende Schleife, nach der Wanduhr, %1 von %2 Takten verspätet und ließ %3 aus.</translation>
    </message>
    <message>
        <source>Suggested: the tool as it is. %1 points, spread evenly, would be no farther apart than the voxels (%2 mm).</source>
        <translation>Vorschlag: das Werkzeug, wie es ist. %1 Punkte, gleichmäßig verteilt, wären nicht weiter voneinander entfernt als die Voxel (%2 mm).</translation>
    </message>
    <message>
        <source>Suggested: %1 points, spread evenly. They are %2 mm apart, as the voxels are.</source>
        <translation>Vorschlag: %1 Punkte, gleichmäßig verteilt. Sie sind %2 mm voneinander entfernt, wie die Voxel.</translation>
    </message>
    <message>
        <source>Suggested: %1 points, spread evenly, %2 mm apart: the most that was carried. To be no farther apart than the voxels (%3 mm), the tool would need %4.</source>
        <translation>Vorschlag: %1 Punkte, gleichmäßig verteilt, %2 mm voneinander entfernt: das meiste, was getragen wurde. Um nicht weiter voneinander entfernt zu sein als die Voxel (%3 mm), bräuchte das Werkzeug %4.</translation>
    </message>
    <message>
        <source>%1 of %2 were cut by the budget of %3 ms, which kept the tool %4 mm farther from the hand on average.</source>
        <translation>%1 von %2 wurden vom Budget von %3 ms gekürzt, was das Werkzeug im Mittel %4 mm weiter von der Hand hielt.</translation>
    </message>
</context>
<context>
    <name>ui::PlacePick</name>
    <message>
        <source>Click a piece, or %1 at the crosshair: shows it. Escape: ends.</source>
        <translation>Auf ein Stück klicken, oder %1 am Fadenkreuz: zeigt es. Esc: beendet.</translation>
    </message>
</context>
<context>
    <name>ui::PlaceTiles</name>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>Opens %1 again</source>
        <translation>Öffnet %1 wieder</translation>
    </message>
    <message>
        <source>%1 is no longer there</source>
        <translation>%1 ist nicht mehr da</translation>
    </message>
    <message>
        <source>Open %1. %2</source>
        <translation>%1 öffnen. %2</translation>
    </message>
</context>
<context>
    <name>ui::PreferencesWindow</name>
    <message>
        <source>Preferences</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>The arrow keys go from page to page</source>
        <translation>Die Pfeiltasten gehen von Seite zu Seite</translation>
    </message>
    <message>
        <source>Reset to &amp;defaults</source>
        <translation>Auf Vor&amp;gaben zurücksetzen</translation>
    </message>
    <message>
        <source>Sets all pages but the shortcuts as they are at first</source>
        <translation>Stellt alle Seiten außer den Tastenkürzeln, wie sie am Anfang sind</translation>
    </message>
    <message>
        <source>Closes the window; all is kept</source>
        <translation>Schließt das Fenster; alles ist behalten</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>The colours of the window</source>
        <translation>Die Farben des Fensters</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Längen</translation>
    </message>
    <message>
        <source>The unit of measures, positions, slabs and rulers</source>
        <translation>Die Einheit von Maßen, Positionen, Slabs und Linealen</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation>Zentimeter</translation>
    </message>
    <message>
        <source>Shows a line of hints at the foot of each view</source>
        <translation>Zeigt am Fuß jeder Ansicht eine Zeile mit Hinweisen</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>&amp;Lengths</source>
        <translation>&amp;Längen</translation>
    </message>
    <message>
        <source>In measures and slices. Voxels, tools and the fields of edits stay in millimetres, forces in newtons.</source>
        <translation>In Maßen und Schnittbildern. Voxel, Werkzeuge und die Felder der Bearbeitungen bleiben in Millimetern, Kräfte in Newton.</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>At first the mouse</source>
        <translation>Am Anfang die Maus</translation>
    </message>
    <message>
        <source>looks: a drag turns the picture</source>
        <translation>schaut: Ziehen dreht das Bild</translation>
    </message>
    <message>
        <source>Wheel over slices, turned away</source>
        <translation>Rad über Schnittbildern, weggedreht</translation>
    </message>
    <message>
        <source>next slice</source>
        <translation>nächste Schicht</translation>
    </message>
    <message>
        <source>slice before</source>
        <translation>vorige Schicht</translation>
    </message>
    <message>
        <source>Wheel for the size, turned away</source>
        <translation>Rad für die Größe, weggedreht</translation>
    </message>
    <message>
        <source>&amp;At first the mouse</source>
        <translation>&amp;Am Anfang die Maus</translation>
    </message>
    <message>
        <source>Wheel over &amp;slices, turned away</source>
        <translation>Rad über &amp;Schnittbildern, weggedreht</translation>
    </message>
    <message>
        <source>Wheel for the si&amp;ze, turned away</source>
        <translation>Rad für die G&amp;röße, weggedreht</translation>
    </message>
    <message>
        <source>All that the mouse does is in the list of shortcuts.</source>
        <translation>Alles, was die Maus tut, steht in der Liste der Tastenkürzel.</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Abtasten</translation>
    </message>
    <message>
        <source>Begin each time with the &amp;stiffness</source>
        <translation>Jedes Mal beginnen mit der Stei&amp;figkeit</translation>
    </message>
    <message>
        <source>Stiffness at first</source>
        <translation>Steifigkeit am Anfang</translation>
    </message>
    <message>
        <source>The spring between hand and tool; a haptic device brings its own</source>
        <translation>Die Feder zwischen Hand und Werkzeug; ein haptisches Gerät bringt seine eigene mit</translation>
    </message>
    <message>
        <source> N/m</source>
        <translation> N/m</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>&amp;Choose a folder…</source>
        <translation>&amp;Ordner wählen…</translation>
    </message>
    <message>
        <source>New recordings are written there, and listed from there</source>
        <translation>Neue Aufzeichnungen werden dorthin geschrieben und von dort aufgelistet</translation>
    </message>
    <message>
        <source>&amp;Own folder</source>
        <translation>&amp;Eigener Ordner</translation>
    </message>
    <message>
        <source>Takes Palpate&apos;s own folder among your files again</source>
        <translation>Nimmt wieder Palpates eigenen Ordner unter Ihren Dateien</translation>
    </message>
    <message>
        <source>Recordings are in</source>
        <translation>Aufzeichnungen liegen in</translation>
    </message>
    <message>
        <source>Recordings that are there stay where they are. A recording that is running is finished where it began.</source>
        <translation>Aufzeichnungen, die dort sind, bleiben, wo sie sind. Eine laufende Aufzeichnung wird beendet, wo sie begann.</translation>
    </message>
    <message>
        <source>Privacy</source>
        <translation>Datenschutz</translation>
    </message>
    <message>
        <source>&amp;Remember recent places</source>
        <translation>&amp;Letzte Orte merken</translation>
    </message>
    <message>
        <source>&amp;Forget them now</source>
        <translation>&amp;Jetzt vergessen</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>No place is remembered.</source>
        <translation>Kein Ort ist gemerkt.</translation>
    </message>
    <message>
        <source>One place is remembered.</source>
        <translation>Ein Ort ist gemerkt.</translation>
    </message>
    <message>
        <source>%1 places are remembered.</source>
        <translation>%1 Orte sind gemerkt.</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>Ordner der Aufzeichnungen</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>The language of the window; the help is in English</source>
        <translation>Die Sprache des Fensters; die Hilfe ist auf Englisch</translation>
    </message>
    <message>
        <source>L&amp;anguage</source>
        <translation>S&amp;prache</translation>
    </message>
    <message>
        <source>How often in a second the touch is computed</source>
        <translation>Wie oft in der Sekunde die Berührung berechnet wird</translation>
    </message>
    <message>
        <source>As the device allows</source>
        <translation>Wie es das Gerät erlaubt</translation>
    </message>
    <message>
        <source>%1 times a second</source>
        <translation>%1-mal in der Sekunde</translation>
    </message>
    <message>
        <source>Touch is &amp;computed</source>
        <translation>Berührung wird &amp;berechnet</translation>
    </message>
    <message>
        <source>Show the mouse&apos;s functions below each view</source>
        <translation>Die Funktionen der Maus unter jeder Ansicht zeigen</translation>
    </message>
    <message>
        <source>The language changes at the next start.</source>
        <translation>Die Sprache ändert sich beim nächsten Start.</translation>
    </message>
    <message>
        <source>Function of a drag in the 3-D view when the mouse becomes the hand</source>
        <translation>Funktion des Ziehens in der 3-D-Ansicht, wenn die Maus die Hand wird</translation>
    </message>
    <message>
        <source>takes the tool: a drag moves it</source>
        <translation>nimmt das Werkzeug: Ziehen bewegt es</translation>
    </message>
    <message>
        <source>Slice that follows when the wheel is turned away from you</source>
        <translation>Schicht, die folgt, wenn das Rad von Ihnen weggedreht wird</translation>
    </message>
    <message>
        <source>Zoom in 3-D, and with Ctrl over slices, when the wheel is turned away from you</source>
        <translation>Vergrößerung in 3-D, und mit Strg über Schnittbildern, wenn das Rad von Ihnen weggedreht wird</translation>
    </message>
    <message>
        <source>zooms in</source>
        <translation>vergrößert</translation>
    </message>
    <message>
        <source>zooms out</source>
        <translation>verkleinert</translation>
    </message>
    <message>
        <source>If not set, the stiffness of the last session is used</source>
        <translation>Wenn nicht gewählt, gilt die Steifigkeit der letzten Sitzung</translation>
    </message>
    <message>
        <source>A haptic device begins with half of its rated stiffness.</source>
        <translation>Ein haptisches Gerät beginnt mit der Hälfte seiner Nennsteifigkeit.</translation>
    </message>
    <message>
        <source>A higher rate allows a stiffer touch, and needs as much more of the processor. It applies to the next device or hand that is opened; a device gets no more than its link allows, the mouse 1 kHz unless you choose.</source>
        <translation>Eine höhere Rate erlaubt eine steifere Berührung und braucht entsprechend mehr vom Prozessor. Sie gilt für das nächste Gerät oder die nächste Hand, die geöffnet wird; ein Gerät bekommt nicht mehr, als seine Verbindung erlaubt, die Maus 1 kHz, wenn Sie nichts wählen.</translation>
    </message>
    <message>
        <source>Palpate keeps no name, no date and no picture of a scan, and uses the network only if you open a scan from a PACS. It asks before it saves or copies a picture that may show a face.</source>
        <translation>Palpate behält keinen Namen, kein Datum und kein Bild einer Aufnahme und verwendet das Netzwerk nur, wenn Sie eine Aufnahme aus einem PACS öffnen. Es fragt, bevor es ein Bild speichert oder kopiert, das ein Gesicht zeigen kann.</translation>
    </message>
    <message>
        <source>Keeps the eight newest folders and files for File &gt; Open recent, and your work on scans until you save or discard it; off forgets both</source>
        <translation>Behält die acht neuesten Ordner und Dateien für Datei &gt; Zuletzt geöffnet und Ihre Arbeit an Aufnahmen, bis Sie sie speichern oder verwerfen; aus vergisst beides</translation>
    </message>
    <message>
        <source>Removes the recent places and the work that was kept at once</source>
        <translation>Entfernt die letzten Orte und die aufgehobene Arbeit sofort</translation>
    </message>
    <message>
        <source>While you work, marks, notes and edits are kept in your own folder, for your eyes alone, and offered again if Palpate ends before you saved them. Notes are kept as you wrote them.</source>
        <translation>Während Sie arbeiten, werden Marken, Notizen und Bearbeitungen in Ihrem eigenen Ordner aufgehoben, nur für Ihre Augen, und wieder angeboten, wenn Palpate endet, bevor Sie sie gespeichert haben. Notizen werden aufgehoben, wie Sie sie geschrieben haben.</translation>
    </message>
</context>
<context>
    <name>ui::RecordingLines</name>
    <message>
        <source>%L1 N</source>
        <translation>%L1 N</translation>
    </message>
</context>
<context>
    <name>ui::RecordingPanel</name>
    <message>
        <source>room for %1 min</source>
        <translation>Platz für %1 min</translation>
    </message>
    <message>
        <source>room for %1 h</source>
        <translation>Platz für %1 h</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>a label and the name of the file</comment>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>unfinished</source>
        <translation>nicht beendet</translation>
    </message>
    <message>
        <source>Time recorded</source>
        <translation>Aufgezeichnete Zeit</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Note: write no names</source>
        <translation>Notiz: keine Namen</translation>
    </message>
    <message>
        <source>Note of the mark</source>
        <translation>Notiz der Marke</translation>
    </message>
    <message>
        <source>Mark (%1)</source>
        <translation>Marke (%1)</translation>
    </message>
    <message>
        <source>Sets a mark at this moment, with the note (%1, or Enter in the note)</source>
        <translation>Setzt in diesem Augenblick eine Marke, mit der Notiz (%1, oder Eingabe in der Notiz)</translation>
    </message>
    <message>
        <source>Begins a recording of every tick, or ends it</source>
        <translation>Beginnt eine Aufzeichnung jedes Takts, oder beendet sie</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>No recordings yet</source>
        <translation>Noch keine Aufzeichnungen</translation>
    </message>
    <message>
        <source>Enter or a double-click opens a recording</source>
        <translation>Eingabe oder ein Doppelklick öffnet eine Aufzeichnung</translation>
    </message>
    <message>
        <source>Label of the recording</source>
        <translation>Bezeichnung der Aufzeichnung</translation>
    </message>
    <message>
        <source>Label: stays on this computer</source>
        <translation>Bezeichnung: bleibt auf diesem Computer</translation>
    </message>
    <message>
        <source>Writes the chosen recording as tables or as a film</source>
        <translation>Schreibt die gewählte Aufzeichnung als Tabellen oder als Film</translation>
    </message>
    <message>
        <source>Deletes the chosen recording, after a question</source>
        <translation>Löscht die gewählte Aufzeichnung, nach einer Frage</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Stopp</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>&amp;Aufzeichnen</translation>
    </message>
    <message>
        <source>Not recording</source>
        <translation>Keine Aufzeichnung</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Finishing…</source>
        <translation>Wird abgeschlossen…</translation>
    </message>
    <message>
        <source>Stopped by itself: %1</source>
        <translation>Von selbst beendet: %1</translation>
    </message>
    <message>
        <source>%1 samples were lost: the recording is not whole.</source>
        <translation>%1 Abtastwerte gingen verloren: Die Aufzeichnung ist nicht vollständig.</translation>
    </message>
    <message>
        <source>Marked at %1</source>
        <translation>Marke bei %1</translation>
    </message>
    <message>
        <source>force not known</source>
        <translation>Kraft nicht bekannt</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Replays the chosen recording in the scene</source>
        <translation>Gibt die gewählte Aufzeichnung in der Szene wieder</translation>
    </message>
    <message>
        <source>Delete it?</source>
        <translation>Löschen?</translation>
    </message>
    <message>
        <source>Delete the recording %1?</source>
        <translation>Die Aufzeichnung %1 löschen?</translation>
    </message>
    <message>
        <source>It cannot be brought back.</source>
        <translation>Sie lässt sich nicht zurückholen.</translation>
    </message>
    <message>
        <source>force up to %L1 N</source>
        <translation>Kraft bis %L1 N</translation>
    </message>
    <message>
        <source>Note for this mark. Everyone with the recording can read it: do not write names of patients or staff.</source>
        <translation>Notiz zu dieser Marke. Jeder, der die Aufzeichnung hat, kann sie lesen: Schreiben Sie keine Namen von Patienten oder Personal.</translation>
    </message>
    <message>
        <source>Your own words for this recording. They are kept on this computer only: neither the recording nor an export contains them.</source>
        <translation>Ihre eigenen Worte für diese Aufzeichnung. Sie bleiben nur auf diesem Computer: Weder die Aufzeichnung noch ein Export enthält sie.</translation>
    </message>
    <message>
        <source>Restores a recording that was never finished</source>
        <translation>Stellt eine nie abgeschlossene Aufzeichnung wieder her</translation>
    </message>
    <message>
        <source>Recorded ticks</source>
        <translation>Aufgezeichnete Takte</translation>
    </message>
    <message>
        <source>Breaks</source>
        <translation>Lücken</translation>
    </message>
    <message>
        <source>State when it began</source>
        <translation>Beginn mit Datum und Uhrzeit angeben</translation>
    </message>
    <message>
        <source>The next recording and its exports then hold date and time, to join them with other devices. A date can tell who the patient is.</source>
        <translation>Die nächste Aufzeichnung und ihre Exporte enthalten dann Datum und Uhrzeit, um sie mit anderen Geräten zu verbinden. Ein Datum kann verraten, wer der Patient ist.</translation>
    </message>
    <message>
        <source>State which scan it is</source>
        <translation>Angeben, welche Aufnahme es ist</translation>
    </message>
    <message>
        <source>The next recording and its exports then hold an open hash, by which anybody who has this scan recognises it.</source>
        <translation>Die nächste Aufzeichnung und ihre Exporte enthalten dann eine offene Prüfsumme, an der jeder, der diese Aufnahme hat, sie wiedererkennt.</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>Writes what the session had to do with the structures on view: times, forces, distances</source>
        <translation>Schreibt, was die Sitzung mit den gezeigten Strukturen zu tun hatte: Zeiten, Kräfte, Abstände</translation>
    </message>
</context>
<context>
    <name>ui::ReplayBar</name>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>One tick back</source>
        <translation>Einen Takt zurück</translation>
    </message>
    <message>
        <source>One tick forward</source>
        <translation>Einen Takt vor</translation>
    </message>
    <message>
        <source>Play or pause (%1 while the bar has the focus)</source>
        <translation>Abspielen oder Pause (%1, solange die Leiste den Fokus hat)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Back to the live session</source>
        <translation>Zurück zur laufenden Sitzung</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>How fast the recording plays</source>
        <translation>Wie schnell die Aufzeichnung abgespielt wird</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Marks (%1)</source>
        <translation>Marken (%1)</translation>
    </message>
    <message>
        <source>No marks</source>
        <translation>Keine Marken</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>%L1 ×</source>
        <translation>%L1 ×</translation>
    </message>
    <message>
        <source>Shows a mark that was set during the recording</source>
        <translation>Zeigt eine Marke, die bei der Aufzeichnung gesetzt wurde</translation>
    </message>
    <message>
        <source>Step back</source>
        <translation>Schritt zurück</translation>
    </message>
    <message>
        <source>Step on</source>
        <translation>Schritt vor</translation>
    </message>
</context>
<context>
    <name>ui::ReplayTimeline</name>
    <message>
        <source>Mark</source>
        <translation>Marke</translation>
    </message>
    <message>
        <source>Isovalue</source>
        <translation>Isowert</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Angular stiffness</source>
        <translation>Drehsteifigkeit</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Force scale</source>
        <translation>Kraftmaßstab</translation>
    </message>
    <message>
        <source>Position scale</source>
        <translation>Positionsmaßstab</translation>
    </message>
    <message>
        <source>Clutch</source>
        <translation>Kupplung</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Gap: samples lost</source>
        <translation>Lücke: verlorene Abtastwerte</translation>
    </message>
    <message>
        <source>Ticks that began late</source>
        <translation>Takte, die verspätet begannen</translation>
    </message>
    <message>
        <source>Ticks that were missed</source>
        <translation>Takte, die ausgelassen wurden</translation>
    </message>
    <message>
        <source>▼ mark  ◆ setting  ■ scene, camera  ● force, device  × samples lost  | ticks late</source>
        <translation>▼ Marke  ◆ Einstellung  ■ Szene, Kamera  ● Kraft, Gerät  × verloren  | verspätet</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Time in the recording</source>
        <translation>Zeit in der Aufzeichnung</translation>
    </message>
    <message>
        <source>%1 in seconds</source>
        <translation>%1 in Sekunden</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weiteres</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>0</source>
        <translation>0</translation>
    </message>
    <message>
        <source>%L1 N</source>
        <translation>%L1 N</translation>
    </message>
    <message>
        <source>greatest force %L1 N</source>
        <translation>größte Kraft %L1 N</translation>
    </message>
    <message>
        <source>Click or drag to choose the time; point at an event for its name</source>
        <translation>Klicken oder ziehen Sie, um die Zeit zu wählen; zeigen Sie auf ein Ereignis, um seinen Namen zu sehen</translation>
    </message>
</context>
<context>
    <name>ui::ReportMoments</name>
    <message>
        <source>Moments of %1</source>
        <translation>Momente von %1</translation>
    </message>
    <message>
        <source>Moments of the session</source>
        <translation>Momente der Sitzung</translation>
    </message>
    <message>
        <source>A click or Enter shows the moment in the replay</source>
        <translation>Ein Klick oder Enter zeigt den Moment in der Wiedergabe</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Was geschah</translation>
    </message>
    <message>
        <source>The tool came near no structure.</source>
        <translation>Das Werkzeug kam keiner Struktur nahe.</translation>
    </message>
</context>
<context>
    <name>ui::SaveDialog</name>
    <message>
        <source>Notes are saved as you wrote them: do not name the patient.</source>
        <translation>Notizen werden so gespeichert, wie Sie sie schreiben: Nennen Sie den Patienten nicht.</translation>
    </message>
</context>
<context>
    <name>ui::SecondSurface</name>
    <message>
        <source>Isovalue of the second surface</source>
        <translation>Isowert der zweiten Oberfläche</translation>
    </message>
    <message>
        <source>The intensity of the second surface, which is seen and not felt</source>
        <translation>Der Wert der zweiten Oberfläche, die man sieht und nicht fühlt</translation>
    </message>
    <message>
        <source>Opacity of the second surface</source>
        <translation>Deckkraft der zweiten Oberfläche</translation>
    </message>
    <message>
        <source>How much of what lies behind it the second surface hides</source>
        <translation>Wie viel von dem, was hinter ihr liegt, die zweite Oberfläche verdeckt</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Second surface</source>
        <translation>Zweite Oberfläche</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
</context>
<context>
    <name>ui::Section</name>
    <message>
        <source>Unfold</source>
        <translation>Aufklappen</translation>
    </message>
    <message>
        <source>Fold</source>
        <translation>Zuklappen</translation>
    </message>
    <message>
        <source>%1, folded</source>
        <translation>%1, zugeklappt</translation>
    </message>
    <message>
        <source>%1, unfolded</source>
        <translation>%1, aufgeklappt</translation>
    </message>
</context>
<context>
    <name>ui::SeriesBrowser</name>
    <message>
        <source>sound</source>
        <translation>einwandfrei</translation>
    </message>
    <message>
        <source>correctable</source>
        <translation>korrigierbar</translation>
    </message>
    <message>
        <source>in part</source>
        <translation>teilweise</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>%1 × %2 × %3</source>
        <translation>%1 × %2 × %3</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>Series of %1</source>
        <translation>Serien von %1</translation>
    </message>
    <message>
        <source>Show patients&apos; &amp;names</source>
        <translation>&amp;Namen der Patienten zeigen</translation>
    </message>
    <message numerus="yes">
        <source>%n series found</source>
        <translation>
            <numerusform>%n Serie gefunden</numerusform>
            <numerusform>%n Serien gefunden</numerusform>
        </translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Serie</translation>
    </message>
    <message>
        <source>Enter or a double-click loads a series</source>
        <translation>Eingabe oder ein Doppelklick lädt eine Serie</translation>
    </message>
    <message>
        <source>Middle slice</source>
        <translation>Mittlere Schicht</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Modality</source>
        <translation>Modalität</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxel</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Beurteilung</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>Load series %1</source>
        <translation>Serie %1 laden</translation>
    </message>
    <message>
        <source>Loads this series</source>
        <translation>Lädt diese Serie</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>no picture</source>
        <translation>kein Bild</translation>
    </message>
    <message>
        <source>Shows the patients&apos; names until the list is closed</source>
        <translation>Zeigt die Namen der Patienten, bis die Liste geschlossen wird</translation>
    </message>
    <message>
        <source>Details of the selected series</source>
        <translation>Einzelheiten der gewählten Serie</translation>
    </message>
    <message>
        <source>Closes the list; the present scan stays</source>
        <translation>Schließt die Liste; die jetzige Aufnahme bleibt</translation>
    </message>
    <message>
        <source>structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open structures %1</source>
        <translation>Strukturen %1 öffnen</translation>
    </message>
    <message>
        <source>Opens these structures in the scan on view</source>
        <translation>Öffnet diese Strukturen in der gezeigten Aufnahme</translation>
    </message>
</context>
<context>
    <name>ui::SetUpDialog</name>
    <message>
        <source>Set up: %1</source>
        <translation>Einrichten: %1</translation>
    </message>
</context>
<context>
    <name>ui::ShortcutList</name>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>up</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>down</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>&amp;Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Search shortcuts</source>
        <translation>Tastenkürzel suchen</translation>
    </message>
    <message>
        <source>Shows the lines that have all these words</source>
        <translation>Zeigt die Zeilen, die alle diese Wörter haben</translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Enter or a double-click changes the key of a line</source>
        <translation>Eingabe oder ein Doppelklick ändert die Taste einer Zeile</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Taste</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Gives the chosen line the key that it has at first</source>
        <translation>Gibt der gewählten Zeile die Taste, die sie am Anfang hat</translation>
    </message>
    <message>
        <source>Gives every line the key that it has at first</source>
        <translation>Gibt jeder Zeile die Taste, die sie am Anfang hat</translation>
    </message>
    <message>
        <source>At first: %1</source>
        <translation>Am Anfang: %1</translation>
    </message>
    <message>
        <source>Press Change, then the key.</source>
        <translation>Drücken Sie Ändern, dann die Taste.</translation>
    </message>
    <message>
        <source>Search: a key, a place or a function</source>
        <translation>Suche: eine Taste, ein Ort oder eine Funktion</translation>
    </message>
    <message>
        <source>Function</source>
        <translation>Funktion</translation>
    </message>
    <message>
        <source>Escape and Space stop the force and cannot be changed.</source>
        <translation>Esc und die Leertaste halten die Kraft an und lassen sich nicht ändern.</translation>
    </message>
    <message>
        <source>The mouse&apos;s functions cannot be changed.</source>
        <translation>Die Funktionen der Maus lassen sich nicht ändern.</translation>
    </message>
</context>
<context>
    <name>ui::SidePanel</name>
    <message>
        <source>Scan</source>
        <translation>Aufnahme</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Abtasten</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>The haptic device</source>
        <translation>Das haptische Gerät</translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation>Aufzeichnungen</translation>
    </message>
    <message>
        <source>Measures and marks</source>
        <translation>Maße und Marken</translation>
    </message>
    <message>
        <source>Surface, tool and hand, remove parts</source>
        <translation>Fläche, Werkzeug und Hand, Teile entfernen</translation>
    </message>
</context>
<context>
    <name>ui::SliceSet</name>
    <message>
        <source>&amp;Show all slices whole</source>
        <translation>Alle Schnittbilder ganz &amp;zeigen</translation>
    </message>
    <message>
        <source>&amp;Contour of the touched surface</source>
        <translation>&amp;Kontur der berührten Oberfläche</translation>
    </message>
    <message>
        <source>Cross&amp;hair</source>
        <translation>Fa&amp;denkreuz</translation>
    </message>
    <message>
        <source>&amp;Follow the tool</source>
        <translation>Dem Werkzeug &amp;folgen</translation>
    </message>
    <message>
        <source>View with the &amp;tool</source>
        <translation>Ansicht mit dem &amp;Werkzeug</translation>
    </message>
    <message>
        <source>Tool view: &amp;along its axis</source>
        <translation>Werkzeugansicht: ent&amp;lang seiner Achse</translation>
    </message>
    <message>
        <source>Tool view: &amp;down its axis</source>
        <translation>Werkzeugansicht: &amp;quer zu seiner Achse</translation>
    </message>
    <message>
        <source>Save &amp;picture of a slice…</source>
        <translation>&amp;Bild eines Schnittbilds speichern…</translation>
    </message>
    <message>
        <source>Saves the slice as it is shown</source>
        <translation>Speichert das Schnittbild, wie es gezeigt wird</translation>
    </message>
    <message>
        <source>&amp;Window and level</source>
        <translation>Fenste&amp;rung</translation>
    </message>
    <message>
        <source>%1 (W %2, L %3)</source>
        <translation>%1 (W %2, C %3)</translation>
    </message>
    <message>
        <source>&amp;Full range</source>
        <translation>&amp;Ganzer Bereich</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>Zu&amp;rücksetzen</translation>
    </message>
    <message>
        <source>&amp;Voxels</source>
        <translation>&amp;Voxel</translation>
    </message>
    <message>
        <source>&amp;Interpolated</source>
        <translation>&amp;Interpoliert</translation>
    </message>
    <message>
        <source>As they a&amp;re</source>
        <translation>&amp;Wie sie sind</translation>
    </message>
    <message>
        <source>&amp;One plane</source>
        <translation>&amp;Eine Ebene</translation>
    </message>
    <message>
        <source>%1 thick</source>
        <translation>%1 dick</translation>
    </message>
    <message>
        <source>Other &amp;thickness…</source>
        <translation>Andere &amp;Dicke…</translation>
    </message>
    <message>
        <source>Thick slab</source>
        <translation>Slab</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>&amp;Thickness</source>
        <translation>&amp;Dicke</translation>
    </message>
    <message>
        <source>Along the tool</source>
        <translation>Entlang des Werkzeugs</translation>
    </message>
    <message>
        <source>Down the tool</source>
        <translation>Quer zum Werkzeug</translation>
    </message>
    <message>
        <source>no tool yet</source>
        <translation>noch kein Werkzeug</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>tip</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>through its axis</source>
        <translation>durch seine Achse</translation>
    </message>
    <message>
        <source>at its tip</source>
        <translation>an seiner Spitze</translation>
    </message>
    <message>
        <source>Sl&amp;ices</source>
        <translation>Schn&amp;ittbilder</translation>
    </message>
    <message>
        <source>Fit all slices to the &amp;body</source>
        <translation>Alle Schichten dem Kör&amp;per anpassen</translation>
    </message>
    <message>
        <source>&amp;Level and width…</source>
        <translation>&amp;Zentrum und Breite…</translation>
    </message>
    <message>
        <source>Level and width</source>
        <translation>Zentrum und Breite</translation>
    </message>
    <message>
        <source>&amp;Level</source>
        <translation>&amp;Zentrum</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>Thick s&amp;lab</source>
        <translation>&amp;Slab</translation>
    </message>
    <message>
        <source>&amp;Maximum</source>
        <translation>M&amp;aximum</translation>
    </message>
    <message>
        <source>Mi&amp;nimum</source>
        <translation>Mi&amp;nimum</translation>
    </message>
    <message>
        <source>M&amp;ean</source>
        <translation>Mi&amp;ttelwert</translation>
    </message>
</context>
<context>
    <name>ui::SliceView</name>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>%1 slice</source>
        <translation>%1-Schnitt</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>maximum of %1</source>
        <translation>Maximum von %1</translation>
    </message>
    <message>
        <source>mean of %1</source>
        <translation>Mittelwert von %1</translation>
    </message>
    <message>
        <source>W %1  L %2</source>
        <translation>W %1  C %2</translation>
    </message>
    <message>
        <source>left/right unknown</source>
        <translation>links/rechts unbekannt</translation>
    </message>
    <message>
        <source>minimum of %1</source>
        <translation>Minimum von %1</translation>
    </message>
    <message>
        <source>Wheel: slices. Drag: crosshair. Right drag: grey. Ctrl+wheel: nearer. %1: fits all.</source>
        <translation>Rad: Schichten. Ziehen: Fadenkreuz. Rechts ziehen: Grau. Strg+Rad: näher. %1: passt alle ein.</translation>
    </message>
    <message>
        <source>Ax.</source>
        <comment>axial</comment>
        <translation>Ax.</translation>
    </message>
    <message>
        <source>Cor.</source>
        <comment>coronal</comment>
        <translation>Kor.</translation>
    </message>
    <message>
        <source>Sag.</source>
        <comment>sagittal</comment>
        <translation>Sag.</translation>
    </message>
    <message>
        <source>scan</source>
        <translation>Scan</translation>
    </message>
</context>
<context>
    <name>ui::SmallPicture</name>
    <message>
        <source>The file does not state its orientation: the slice is shown as it is stored, and left and right are unknown.</source>
        <translation>Die Datei nennt ihre Ausrichtung nicht: Die Schicht ist gezeigt, wie sie gespeichert ist; links und rechts sind unbekannt.</translation>
    </message>
</context>
<context>
    <name>ui::StartPage</name>
    <message>
        <source>Open your CT</source>
        <translation>Ihre CT-Aufnahme öffnen</translation>
    </message>
    <message>
        <source>A folder of DICOM slices, an archive, or an NRRD, MetaImage or NIfTI file. It can also be dropped on the window.</source>
        <translation>Einen Ordner mit DICOM-Schichten, ein Archiv oder eine Datei von NRRD, MetaImage oder NIfTI. Sie lässt sich auch auf das Fenster ziehen.</translation>
    </message>
    <message>
        <source>Open folder…</source>
        <translation>Ordner öffnen…</translation>
    </message>
    <message>
        <source>Open file…</source>
        <translation>Datei öffnen…</translation>
    </message>
    <message>
        <source>Opens a folder of slices</source>
        <translation>Öffnet einen Ordner mit Schichten</translation>
    </message>
    <message>
        <source>Opens an archive or a volume in one file</source>
        <translation>Öffnet ein Archiv oder ein Volumen in einer Datei</translation>
    </message>
    <message>
        <source>Try the demo skull</source>
        <translation>Den Demoschädel versuchen</translation>
    </message>
    <message>
        <source>A skull made by a formula, and a drill to touch it with. The mouse is the hand, so nothing else is needed.</source>
        <translation>Ein Schädel aus einer Formel und ein Bohrer, um ihn zu tasten. Die Maus ist die Hand, also ist sonst nichts nötig.</translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>Versuchen</translation>
    </message>
    <message>
        <source>Shows the demo skull with a drill</source>
        <translation>Zeigt den Demoschädel mit einem Bohrer</translation>
    </message>
    <message>
        <source>Connect a haptic device</source>
        <translation>Ein haptisches Gerät verbinden</translation>
    </message>
    <message>
        <source>Show devices</source>
        <translation>Geräte zeigen</translation>
    </message>
    <message>
        <source>Shows the list of haptic devices on the tab Device</source>
        <translation>Zeigt die Liste der haptischen Geräte auf dem Reiter Gerät</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Recent places are not remembered (File &gt; Open recent)</source>
        <translation>Letzte Orte werden nicht gemerkt (Datei &gt; Zuletzt geöffnet)</translation>
    </message>
    <message>
        <source>The scans that you open will stand here</source>
        <translation>Die Aufnahmen, die Sie öffnen, stehen dann hier</translation>
    </message>
    <message>
        <source>Last scans</source>
        <translation>Letzte Aufnahmen</translation>
    </message>
    <message>
        <source>See a CT scan, and feel its surface.</source>
        <translation>Einen CT-Scan sehen und seine Oberfläche fühlen.</translation>
    </message>
    <message>
        <source>Feel the scan: a Falcon, Touch, Inverse3 and others. The list shows the devices found and their needs.</source>
        <translation>Die Aufnahme fühlen: mit Falcon, Touch, Inverse3 und anderen. Die Liste zeigt die gefundenen Geräte und was sie brauchen.</translation>
    </message>
    <message>
        <source>Cancels loading and shows the start page</source>
        <translation>Bricht das Laden ab und zeigt die Startseite</translation>
    </message>
</context>
<context>
    <name>ui::StateChip</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>ui::StatusLine</name>
    <message>
        <source>ordinary priority</source>
        <translation>gewöhnliche Priorität</translation>
    </message>
    <message>
        <source>real-time priority</source>
        <translation>Echtzeitpriorität</translation>
    </message>
    <message>
        <source>servo %1 Hz (%2), tick p99 %3 µs, late %4, missed %5</source>
        <translation>Servo %1 Hz (%2), Takt p99 %3 µs, verspätet %4, ausgelassen %5</translation>
    </message>
    <message>
        <source>Hand: %1</source>
        <translation>Hand: %1</translation>
    </message>
    <message>
        <source>ray casting</source>
        <translation>Raycasting</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>Gitternetz</translation>
    </message>
    <message>
        <source>Surface: %1 (%2)</source>
        <translation>Oberfläche: %1 (%2)</translation>
    </message>
    <message>
        <source>%L1 N · %2 contacts</source>
        <translation>%L1 N · %2 Kontakte</translation>
    </message>
    <message>
        <source>Status line</source>
        <translation>Statuszeile</translation>
    </message>
    <message>
        <source>Nearest: %1, %2</source>
        <translation>Am nächsten: %1, %2</translation>
    </message>
</context>
<context>
    <name>ui::StopButton</name>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>STOP FORCE</source>
        <translation>KRAFT AUS</translation>
    </message>
    <message>
        <source>Stop force (Escape)</source>
        <translation>Kraft aus (Esc)</translation>
    </message>
    <message>
        <source>Zero force at once (Escape anywhere, Space in the 3-D view)</source>
        <translation>Sofort keine Kraft (Esc überall, die Leertaste in der 3-D-Ansicht)</translation>
    </message>
</context>
<context>
    <name>ui::StructuresPanel</name>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Shows it, or hides it</source>
        <translation>Zeigt sie oder verbirgt sie</translation>
    </message>
    <message>
        <source>Colour of %1</source>
        <translation>Farbe von %1</translation>
    </message>
    <message>
        <source>A click chooses another colour</source>
        <translation>Ein Klick wählt eine andere Farbe</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Search the structures</source>
        <translation>In den Strukturen suchen</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Lists the structures whose names have these letters</source>
        <translation>Listet die Strukturen, deren Namen diese Buchstaben enthalten</translation>
    </message>
    <message>
        <source>Opens the structures of this scan from a file: a segmentation by another program</source>
        <translation>Öffnet die Strukturen dieser Aufnahme aus einer Datei: eine Segmentierung eines anderen Programms</translation>
    </message>
    <message>
        <source>Takes the structures from the views; the file stays</source>
        <translation>Nimmt die Strukturen aus den Ansichten; die Datei bleibt</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>%1 turns the views to the structure, %2 renames it, %3 shows or hides it</source>
        <translation>%1 dreht die Ansichten zur Struktur, %2 benennt sie um, %3 zeigt oder verbirgt sie</translation>
    </message>
    <message>
        <source>Chooses another colour</source>
        <translation>Wählt eine andere Farbe</translation>
    </message>
    <message>
        <source>Turns the 3-D view to the structure, and brings the slices to its middle</source>
        <translation>Dreht die 3-D-Ansicht zur Struktur und bringt die Schichten zu ihrer Mitte</translation>
    </message>
    <message>
        <source>Renames the structure, here alone</source>
        <translation>Benennt die Struktur um, nur hier</translation>
    </message>
    <message>
        <source>Opacity of the structure</source>
        <translation>Deckkraft der Struktur</translation>
    </message>
    <message>
        <source>How much of what lies behind it the structure hides</source>
        <translation>Wie viel von dem, was hinter ihr liegt, die Struktur verdeckt</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Shows all structures</source>
        <translation>Zeigt alle Strukturen</translation>
    </message>
    <message>
        <source>Hides all structures</source>
        <translation>Verbirgt alle Strukturen</translation>
    </message>
    <message>
        <source>Draws the outlines of structures over the bone that hides them</source>
        <translation>Zeichnet die Umrisse von Strukturen über den Knochen, der sie verdeckt</translation>
    </message>
    <message>
        <source>Fills the structures in slices, so that the anatomy is seen through</source>
        <translation>Füllt die Strukturen in Schichten, sodass die Anatomie hindurchscheint</translation>
    </message>
    <message>
        <source>Colour of a structure</source>
        <translation>Farbe einer Struktur</translation>
    </message>
    <message>
        <source>Go to</source>
        <translation>Hingehen</translation>
    </message>
    <message>
        <source>Only this</source>
        <translation>Nur diese</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Colour…</source>
        <translation>Farbe…</translation>
    </message>
    <message>
        <source>Through the bone</source>
        <translation>Durch den Knochen</translation>
    </message>
    <message>
        <source>Filled in slices</source>
        <translation>In Schichten gefüllt</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>All on</source>
        <translation>Alle an</translation>
    </message>
    <message>
        <source>All off</source>
        <translation>Alle aus</translation>
    </message>
    <message>
        <source>Tell the distance</source>
        <translation>Abstand nennen</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Near from</source>
        <translation>Nah ab</translation>
    </message>
    <message>
        <source>Close from</source>
        <translation>Sehr nah ab</translation>
    </message>
    <message>
        <source>As the scan has it</source>
        <translation>Wie in der Aufnahme</translation>
    </message>
    <message>
        <source>Nothing changes where the structure is touched</source>
        <translation>Nichts ändert sich, wo die Struktur berührt wird</translation>
    </message>
    <message>
        <source>Softer</source>
        <translation>Weicher</translation>
    </message>
    <message>
        <source>Where the structure is touched, what is felt gives way</source>
        <translation>Wo die Struktur berührt wird, gibt nach, was man fühlt</translation>
    </message>
    <message>
        <source>Guarded</source>
        <translation>Geschützt</translation>
    </message>
    <message>
        <source>A force keeps the tool away from the structure</source>
        <translation>Eine Kraft hält das Werkzeug von der Struktur fern</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source> N/m</source>
        <translation> N/m</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>Found with the scan</source>
        <translation>Bei der Aufnahme gefunden</translation>
    </message>
    <message>
        <source>Opens DICOM structures that lie with the scan: segmentations, contours</source>
        <translation>Öffnet DICOM-Strukturen, die bei der Aufnahme liegen: Segmentierungen, Konturen</translation>
    </message>
    <message>
        <source>How the structure is felt</source>
        <translation>Wie die Struktur sich anfühlt</translation>
    </message>
    <message>
        <source>What is felt beside the surface of the scan; the distance is told then</source>
        <translation>Was neben der Oberfläche der Aufnahme gefühlt wird; der Abstand wird dann genannt</translation>
    </message>
    <message>
        <source>Felt</source>
        <translation>Gefühlt</translation>
    </message>
    <message>
        <source>Tells how far the tool is from the structure, beside the force and in recordings. Its distances need %1 of memory.</source>
        <translation>Nennt neben der Kraft und in Aufzeichnungen, wie weit das Werkzeug von der Struktur ist. Ihre Abstände brauchen %1 Speicher.</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Fest</translation>
    </message>
    <message>
        <source>The structure&apos;s own surface stops the tool, too</source>
        <translation>Auch die eigene Oberfläche der Struktur hält das Werkzeug auf</translation>
    </message>
    <message>
        <source>Not there</source>
        <translation>Nicht da</translation>
    </message>
    <message>
        <source>The tool goes into the structure as into air; what is shown stays</source>
        <translation>Das Werkzeug fährt in die Struktur wie in Luft; zu sehen bleibt sie</translation>
    </message>
    <message>
        <source>Beep when near</source>
        <translation>Piepen, wenn nah</translation>
    </message>
    <message>
        <source>The nearer a structure whose distance is told, the sooner the next beep; close ones beep higher</source>
        <translation>Je näher eine Struktur ist, deren Abstand genannt wird, desto eher kommt der nächste Ton; sehr nahe klingen höher</translation>
    </message>
    <message>
        <source>There is no program that plays sounds: install PipeWire, PulseAudio or ALSA&apos;s utilities</source>
        <translation>Es gibt kein Programm, das Töne spielt: Installieren Sie PipeWire, PulseAudio oder die Programme von ALSA</translation>
    </message>
    <message>
        <source>Of the tissue that is felt there</source>
        <translation>Die des Gewebes, das dort gefühlt wird</translation>
    </message>
    <message>
        <source>Force within</source>
        <translation>Kraft innerhalb</translation>
    </message>
    <message>
        <source>The distance from the structure at which the force begins</source>
        <translation>Der Abstand von der Struktur, in dem die Kraft beginnt</translation>
    </message>
    <message>
        <source>Force at most</source>
        <translation>Kraft höchstens</translation>
    </message>
    <message>
        <source>The greatest force, at the structure and within</source>
        <translation>Die größte Kraft, an der Struktur und darin</translation>
    </message>
    <message>
        <source>Structure %1</source>
        <translation>Struktur %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Shows this structure alone; once more shows what was shown before</source>
        <translation>Zeigt diese Struktur allein; noch einmal zeigt, was zuvor gezeigt war</translation>
    </message>
    <message>
        <source>Tell the distance (%1 of memory)</source>
        <translation>Abstand nennen (%1 Speicher)</translation>
    </message>
    <message>
        <source>Never cut</source>
        <translation>Nie geschnitten</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>How the structure is cut</source>
        <translation>Wie die Struktur geschnitten wird</translation>
    </message>
    <message>
        <source>What a burr removes of it; Undo takes the choice back, as an edit</source>
        <translation>Was ein Bohrer von ihr wegnimmt; Rückgängig nimmt die Wahl zurück, wie eine Bearbeitung</translation>
    </message>
    <message>
        <source>As its values say</source>
        <translation>Wie ihre Werte sagen</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Nie</translation>
    </message>
    <message>
        <source>With this energy</source>
        <translation>Mit dieser Energie</translation>
    </message>
    <message>
        <source>What it takes to remove a cubic millimetre of the structure</source>
        <translation>Was es braucht, einen Kubikmillimeter der Struktur wegzunehmen</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Schneiden</translation>
    </message>
</context>
<context>
    <name>ui::SurfaceDialog</name>
    <message>
        <source>With the parts that were removed</source>
        <translation>Mit den entfernten Teilen</translation>
    </message>
    <message>
        <source>Export the surface</source>
        <translation>Oberfläche exportieren</translation>
    </message>
    <message>
        <source>Format of the file</source>
        <translation>Format der Datei</translation>
    </message>
    <message>
        <source>Directions of x, y and z in the file</source>
        <translation>Richtungen von x, y und z in der Datei</translation>
    </message>
    <message>
        <source>LPS: left, posterior, superior (as in DICOM)</source>
        <translation>LPS: links, hinten, oben (wie in DICOM)</translation>
    </message>
    <message>
        <source>RAS: right, anterior, superior (as in NIfTI)</source>
        <translation>RAS: rechts, vorn, oben (wie in NIfTI)</translation>
    </message>
    <message>
        <source>Which connected parts are written</source>
        <translation>Welche zusammenhängenden Teile geschrieben werden</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>the largest alone</source>
        <translation>nur das größte</translation>
    </message>
    <message>
        <source>Writes the surface of the whole scan, as before all edits</source>
        <translation>Schreibt die Oberfläche der ganzen Aufnahme, wie vor allen Bearbeitungen</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Achsen</translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation>Stücke</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Asks for the file, then writes it</source>
        <translation>Fragt nach der Datei und schreibt sie dann</translation>
    </message>
    <message>
        <source>Writes nothing</source>
        <translation>Schreibt nichts</translation>
    </message>
    <message>
        <source>The triangles are being counted…</source>
        <translation>Die Dreiecke werden gezählt…</translation>
    </message>
    <message>
        <source>%1 triangles, about %2 MB</source>
        <translation>%1 Dreiecke, etwa %2 MB</translation>
    </message>
</context>
<context>
    <name>ui::TextWindow</name>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
</context>
<context>
    <name>ui::TissueBand</name>
    <message>
        <source>air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>fat</source>
        <translation>Fett</translation>
    </message>
    <message>
        <source>soft tissue</source>
        <translation>Weichteile</translation>
    </message>
    <message>
        <source>bone</source>
        <translation>Knochen</translation>
    </message>
</context>
<context>
    <name>ui::ToolList</name>
    <message>
        <source>length %1 mm</source>
        <translation>Länge %1 mm</translation>
    </message>
    <message>
        <source>%1 · tip %2 mm</source>
        <translation>%1 · Spitze %2 mm</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Choose a tool</source>
        <translation>Ein Werkzeug wählen</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>Aus einer Datei…</translation>
    </message>
    <message>
        <source>Tool from a file</source>
        <translation>Werkzeug aus einer Datei</translation>
    </message>
    <message>
        <source>%1; the present tool</source>
        <translation>%1; das jetzige Werkzeug</translation>
    </message>
    <message>
        <source>Tool: %1</source>
        <translation>Werkzeug: %1</translation>
    </message>
    <message>
        <source>No scan, no tool yet</source>
        <translation>Keine Aufnahme, noch kein Werkzeug</translation>
    </message>
</context>
<context>
    <name>ui::ToolTiles</name>
    <message>
        <source>Burr 4 mm</source>
        <translation>Fräse 4 mm</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonde</translation>
    </message>
    <message>
        <source>Hook</source>
        <translation>Haken</translation>
    </message>
</context>
<context>
    <name>ui::TopBar</name>
    <message>
        <source>State of the force</source>
        <translation>Zustand der Kraft</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>REC %1</source>
        <translation>REC %1</translation>
    </message>
</context>
<context>
    <name>ui::TouchState</name>
    <message>
        <source>Force stopped</source>
        <translation>Kraft angehalten</translation>
    </message>
    <message>
        <source>The force may come back: hold the handle</source>
        <translation>Die Kraft kann wiederkommen: Halten Sie den Griff</translation>
    </message>
    <message>
        <source>Nothing to touch yet</source>
        <translation>Noch nichts zu tasten</translation>
    </message>
    <message>
        <source>The force is off after a fault</source>
        <translation>Die Kraft ist nach einer Störung aus</translation>
    </message>
    <message>
        <source>The device is ready: no force until you arm it</source>
        <translation>Das Gerät ist bereit: keine Kraft, bis Sie es freigeben</translation>
    </message>
    <message>
        <source>The force is off</source>
        <translation>Die Kraft ist aus</translation>
    </message>
    <message>
        <source>Arm again</source>
        <translation>Wieder freigeben</translation>
    </message>
    <message>
        <source>Arm</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>%1 · %2 kHz</source>
        <translation>%1 · %2 kHz</translation>
    </message>
</context>
<context>
    <name>ui::Tour</name>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>Ends the tour; Help shows it again</source>
        <translation>Beendet die Einführung; die Hilfe zeigt sie wieder</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Shows the next control</source>
        <translation>Zeigt das nächste Bedienelement</translation>
    </message>
</context>
<context>
    <name>ui::UnitDialog</name>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 long,
%2 by %3</source>
        <translation>%1 lang,
%2 mal %3</translation>
    </message>
    <message>
        <source>Unit of the tool</source>
        <translation>Einheit des Werkzeugs</translation>
    </message>
    <message>
        <source>Take the tool</source>
        <translation>Werkzeug nehmen</translation>
    </message>
    <message>
        <source>In which unit are the numbers of &quot;%1&quot;? The file does not say. The picture shows a hand of 18 cm beside the box of the tool.</source>
        <translation>In welcher Einheit sind die Zahlen von „%1“? Die Datei sagt es nicht. Das Bild zeigt eine Hand von 18 cm neben der Box des Werkzeugs.</translation>
    </message>
</context>
<context>
    <name>ui::ViewActions</name>
    <message>
        <source>Saves a picture of the view or the window</source>
        <translation>Speichert ein Bild der Ansicht oder des Fensters</translation>
    </message>
    <message>
        <source>Cop&amp;y picture</source>
        <translation>Bi&amp;ld kopieren</translation>
    </message>
    <message>
        <source>Copies a picture of the 3-D view</source>
        <translation>Kopiert ein Bild der 3-D-Ansicht</translation>
    </message>
    <message>
        <source>Show &amp;everything</source>
        <translation>All&amp;es zeigen</translation>
    </message>
    <message>
        <source>From a &amp;side</source>
        <translation>Von einer &amp;Seite</translation>
    </message>
    <message>
        <source>Anterior (from the front)</source>
        <translation>Anterior (von vorn)</translation>
    </message>
    <message>
        <source>Posterior (from behind)</source>
        <translation>Posterior (von hinten)</translation>
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
        <source>Superior (from above)</source>
        <translation>Superior (von oben)</translation>
    </message>
    <message>
        <source>Inferior (from below)</source>
        <translation>Inferior (von unten)</translation>
    </message>
    <message>
        <source>From the &amp;tool&apos;s side</source>
        <translation>Von der Seite des Werkzeu&amp;gs</translation>
    </message>
    <message>
        <source>&amp;Along the tool</source>
        <translation>Entlang &amp;des Werkzeugs</translation>
    </message>
    <message>
        <source>A starting point, not a threshold for diagnosis</source>
        <translation>Ein Anfang, keine Schwelle für eine Diagnose</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>Far&amp;be</translation>
    </message>
    <message>
        <source>By tissue</source>
        <translation>Nach Gewebe</translation>
    </message>
    <message>
        <source>Ivory</source>
        <translation>Elfenbein</translation>
    </message>
    <message>
        <source>Second s&amp;urface (seen, not felt)</source>
        <translation>Zweite Ober&amp;fläche (sichtbar, nicht fühlbar)</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>The present isovalue, held</source>
        <translation>Der jetzige Isowert, festgehalten</translation>
    </message>
    <message>
        <source>Ta&amp;ke the tool with the mouse</source>
        <translation>Werkzeug mit der Maus &amp;nehmen</translation>
    </message>
    <message>
        <source>Take tool</source>
        <translation>Werkzeug nehmen</translation>
    </message>
    <message>
        <source>The mouse holds the tool. The tool itself can be dragged at any time</source>
        <translation>Die Maus hält das Werkzeug. Das Werkzeug selbst lässt sich jederzeit ziehen</translation>
    </message>
    <message>
        <source>Sa&amp;ve picture…</source>
        <translation>Bild spei&amp;chern…</translation>
    </message>
    <message>
        <source>Parallel pro&amp;jection</source>
        <translation>&amp;Parallelprojektion</translation>
    </message>
    <message>
        <source>&amp;Presets</source>
        <translation>&amp;Voreinstellungen</translation>
    </message>
    <message>
        <source>T&amp;ool to crosshair</source>
        <translation>Werk&amp;zeug zum Fadenkreuz</translation>
    </message>
    <message>
        <source>Crosshair to tool</source>
        <translation>Fadenkreuz zum Werkzeug</translation>
    </message>
    <message>
        <source>Contacts and &amp;force</source>
        <translation>Kon&amp;takte und Kraft</translation>
    </message>
    <message>
        <source>The unedited scan beside what is left of it, seen from the same place</source>
        <translation>Die unbearbeitete Aufnahme neben dem, was von ihr übrig ist, von derselben Stelle gesehen</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Vorher und nachher</translation>
    </message>
</context>
<context>
    <name>ui::ViewFrame</name>
    <message>
        <source>Choices for slices</source>
        <translation>Auswahl für Schnittbilder</translation>
    </message>
    <message>
        <source>Hide the hints of all views (View &gt; Hints shows them again)</source>
        <translation>Die Hinweise aller Ansichten verbergen (Ansicht &gt; Hinweise zeigt sie wieder)</translation>
    </message>
    <message>
        <source>Hide hints</source>
        <translation>Hinweise verbergen</translation>
    </message>
    <message>
        <source>Show the other views again</source>
        <translation>Die anderen Ansichten wieder zeigen</translation>
    </message>
    <message>
        <source>Show this view alone</source>
        <translation>Diese Ansicht allein zeigen</translation>
    </message>
    <message>
        <source>Fit to the body</source>
        <translation>Dem Körper anpassen</translation>
    </message>
    <message>
        <source>Follow the tool</source>
        <translation>Dem Werkzeug folgen</translation>
    </message>
    <message>
        <source>Shows the body as large as it can be</source>
        <translation>Zeigt den Körper so groß wie möglich</translation>
    </message>
    <message>
        <source>The slices go with the tool. A click lets them stay</source>
        <translation>Die Schichten gehen mit dem Werkzeug. Ein Klick lässt sie stehen</translation>
    </message>
    <message>
        <source>The slices stay. A click lets them go with the tool</source>
        <translation>Die Schichten bleiben stehen. Ein Klick lässt sie mit dem Werkzeug gehen</translation>
    </message>
</context>
<context>
    <name>ui::ViewGap</name>
    <message>
        <source>Border between views</source>
        <translation>Grenze zwischen Ansichten</translation>
    </message>
    <message>
        <source>Drag, or move with the arrow keys. %1 or a double-click: first sizes</source>
        <translation>Ziehen, oder mit den Pfeiltasten bewegen. %1 oder ein Doppelklick: Anfangsgrößen</translation>
    </message>
</context>
<context>
    <name>ui::VolumeProp</name>
    <message>
        <source>OpenGL is older than 3.2</source>
        <translation>OpenGL ist älter als 3.2</translation>
    </message>
    <message>
        <source>the volume is larger than the graphics can hold</source>
        <translation>das Volumen ist größer, als die Grafik fasst</translation>
    </message>
    <message>
        <source>the volume is flat</source>
        <translation>das Volumen ist flach</translation>
    </message>
    <message>
        <source>as asked for</source>
        <translation>wie gewünscht</translation>
    </message>
    <message>
        <source>software graphics</source>
        <translation>Grafik in Software</translation>
    </message>
    <message>
        <source>drawn by the graphics card</source>
        <translation>von der Grafikkarte gezeichnet</translation>
    </message>
</context>
<context>
    <name>ui::VolumeView</name>
    <message>
        <source>3-D view</source>
        <translation>3-D-Ansicht</translation>
    </message>
    <message>
        <source>%1: nothing is open</source>
        <translation>%1: nichts ist geöffnet</translation>
    </message>
    <message>
        <source>%1: surface at %2</source>
        <translation>%1: Oberfläche bei %2</translation>
    </message>
    <message>
        <source>Drag: turns. Wheel: nearer. To touch: drag the tool, or take it with %1. Double-click: brings it there. Middle drag: shifts.</source>
        <translation>Ziehen: dreht. Rad: näher. Tasten: Werkzeug ziehen oder mit %1 nehmen. Doppelklick: bringt es hin. Mitte ziehen: verschiebt.</translation>
    </message>
    <message>
        <source>left/right unknown</source>
        <translation>links/rechts unbekannt</translation>
    </message>
    <message>
        <source>%L1 N</source>
        <translation>%L1 N</translation>
    </message>
    <message>
        <source>Drag or arrow keys: move the tool. Shift: turns it. Wheel: pushes it. Right drag: turns the picture. %1: lets go.</source>
        <translation>Ziehen oder Pfeiltasten: bewegen das Werkzeug. Umschalt: dreht es. Rad: schiebt es. Rechts ziehen: dreht das Bild. %1: lässt los.</translation>
    </message>
    <message>
        <source>Drag: turns. Wheel: nearer. Middle drag: shifts. %1 takes the tool only while the mouse is the hand (tab Touch).</source>
        <translation>Ziehen: dreht. Rad: näher. Mitte ziehen: verschiebt. %1 nimmt das Werkzeug nur, solange die Maus die Hand ist (Reiter Tasten).</translation>
    </message>
    <message>
        <source>Hold %1: cuts.</source>
        <translation>%1 halten: schneidet.</translation>
    </message>
</context>
<context>
    <name>ui::bindings</name>
    <message>
        <source>Alt with a letter opens menus; choose another key.</source>
        <translation>Alt mit einem Buchstaben öffnet Menüs; wählen Sie eine andere Taste.</translation>
    </message>
    <message>
        <source>Fields and lists need this key; choose one with Ctrl.</source>
        <translation>Felder und Listen brauchen diese Taste; wählen Sie eine mit Strg.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 is taken: %2, %3. Give that another key first.</source>
        <translation>%1 ist vergeben: %2, %3. Geben Sie dem zuerst eine andere Taste.</translation>
    </message>
    <message>
        <source>%1, held</source>
        <translation>%1, gehalten</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>Rad</translation>
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
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>%1 drag</source>
        <translation>%1 ziehen</translation>
    </message>
    <message>
        <source>double-click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>%1 click</source>
        <translation>%1 klicken</translation>
    </message>
    <message>
        <source>Shift and %1</source>
        <translation>Umschalt und %1</translation>
    </message>
    <message>
        <source>Ctrl and %1</source>
        <translation>Strg und %1</translation>
    </message>
    <message>
        <source>anywhere</source>
        <translation>überall</translation>
    </message>
    <message>
        <source>any view</source>
        <translation>jede Ansicht</translation>
    </message>
    <message>
        <source>slices</source>
        <translation>Schnittbilder</translation>
    </message>
    <message>
        <source>list of marks</source>
        <translation>Liste der Markierungen</translation>
    </message>
    <message>
        <source>histogram</source>
        <translation>Histogramm</translation>
    </message>
    <message>
        <source>border between views</source>
        <translation>Grenze zwischen Ansichten</translation>
    </message>
    <message>
        <source>replay bar</source>
        <translation>Wiedergabeleiste</translation>
    </message>
    <message>
        <source>3-D view</source>
        <translation>3-D-Ansicht</translation>
    </message>
    <message>
        <source>%1, on the tool</source>
        <translation>%1, auf dem Werkzeug</translation>
    </message>
    <message>
        <source>%1, on the cube</source>
        <translation>%1, auf dem Würfel</translation>
    </message>
    <message>
        <source>%1, on a handle</source>
        <translation>%1, auf einem Griff</translation>
    </message>
    <message>
        <source>%1, while measuring</source>
        <translation>%1, beim Messen</translation>
    </message>
    <message>
        <source>%1, with the tool of an edit</source>
        <translation>%1, mit dem Werkzeug einer Bearbeitung</translation>
    </message>
    <message>
        <source>%1, looking</source>
        <translation>%1, beim Schauen</translation>
    </message>
    <message>
        <source>opens a file</source>
        <translation>öffnet eine Datei</translation>
    </message>
    <message>
        <source>opens a folder</source>
        <translation>öffnet einen Ordner</translation>
    </message>
    <message>
        <source>saves the view</source>
        <translation>speichert die Ansicht</translation>
    </message>
    <message>
        <source>saves a picture of a view or the window</source>
        <translation>speichert ein Bild einer Ansicht oder des Fensters</translation>
    </message>
    <message>
        <source>copies a picture of the 3-D view</source>
        <translation>kopiert ein Bild der 3-D-Ansicht</translation>
    </message>
    <message>
        <source>takes the last edit back</source>
        <translation>nimmt die letzte Bearbeitung zurück</translation>
    </message>
    <message>
        <source>makes it again</source>
        <translation>macht sie noch einmal</translation>
    </message>
    <message>
        <source>opens the preferences</source>
        <translation>öffnet die Einstellungen</translation>
    </message>
    <message>
        <source>quits</source>
        <translation>beendet das Programm</translation>
    </message>
    <message>
        <source>shows all controls</source>
        <translation>zeigt die ganze Bedienung</translation>
    </message>
    <message>
        <source>while recording: sets a mark</source>
        <translation>bei der Aufzeichnung: setzt eine Marke</translation>
    </message>
    <message>
        <source>shows a view alone, or all again</source>
        <translation>zeigt eine Ansicht allein oder wieder alle</translation>
    </message>
    <message>
        <source>places a distance; again: ends it</source>
        <translation>setzt einen Abstand; noch einmal: beendet es</translation>
    </message>
    <message>
        <source>places an angle; again: ends it</source>
        <translation>setzt einen Winkel; noch einmal: beendet es</translation>
    </message>
    <message>
        <source>places a point with its value; again: ends it</source>
        <translation>setzt einen Punkt mit seinem Wert; noch einmal: beendet es</translation>
    </message>
    <message>
        <source>places a note; again: ends it</source>
        <translation>setzt eine Notiz; noch einmal: beendet es</translation>
    </message>
    <message>
        <source>while placing: takes the last place back</source>
        <translation>beim Setzen: nimmt die letzte Stelle zurück</translation>
    </message>
    <message>
        <source>deletes the chosen mark</source>
        <translation>löscht die gewählte Markierung</translation>
    </message>
    <message>
        <source>force off</source>
        <translation>Kraft aus</translation>
    </message>
    <message>
        <source>takes the tool with the mouse, or lets it go</source>
        <translation>nimmt das Werkzeug mit der Maus oder lässt es los</translation>
    </message>
    <message>
        <source>brings the tool to the crosshair</source>
        <translation>bringt das Werkzeug zum Fadenkreuz</translation>
    </message>
    <message>
        <source>brings the crosshair to the tool</source>
        <translation>bringt das Fadenkreuz zum Werkzeug</translation>
    </message>
    <message>
        <source>looks along the tool</source>
        <translation>blickt entlang des Werkzeugs</translation>
    </message>
    <message>
        <source>shows everything from the tool&apos;s side</source>
        <translation>zeigt alles von der Seite des Werkzeugs</translation>
    </message>
    <message>
        <source>shows everything, from the front</source>
        <translation>zeigt alles, von vorn</translation>
    </message>
    <message>
        <source>from the front (A)</source>
        <translation>von vorn (A)</translation>
    </message>
    <message>
        <source>from behind (P)</source>
        <translation>von hinten (P)</translation>
    </message>
    <message>
        <source>from the patient&apos;s left (L)</source>
        <translation>von der linken Seite des Patienten (L)</translation>
    </message>
    <message>
        <source>from the patient&apos;s right (R)</source>
        <translation>von der rechten Seite des Patienten (R)</translation>
    </message>
    <message>
        <source>from above (S)</source>
        <translation>von oben (S)</translation>
    </message>
    <message>
        <source>from below (I)</source>
        <translation>von unten (I)</translation>
    </message>
    <message>
        <source>parallel projection on or off</source>
        <translation>Parallelprojektion ein oder aus</translation>
    </message>
    <message>
        <source>turns the picture</source>
        <translation>dreht das Bild</translation>
    </message>
    <message>
        <source>shifts the picture</source>
        <translation>verschiebt das Bild</translation>
    </message>
    <message>
        <source>clutch; released when the view loses the focus</source>
        <translation>Kupplung; löst sich, wenn die Ansicht den Fokus verliert</translation>
    </message>
    <message>
        <source>hold-to-run; released when the view loses the focus</source>
        <translation>Zustimmtaste; löst sich, wenn die Ansicht den Fokus verliert</translation>
    </message>
    <message>
        <source>next slice: towards S, P or L, with the tool deeper</source>
        <translation>nächste Schicht: nach S, P oder L, mit dem Werkzeug tiefer</translation>
    </message>
    <message>
        <source>slice before</source>
        <translation>vorige Schicht</translation>
    </message>
    <message>
        <source>ten slices on</source>
        <translation>zehn Schichten weiter</translation>
    </message>
    <message>
        <source>ten slices back</source>
        <translation>zehn Schichten zurück</translation>
    </message>
    <message>
        <source>first slice</source>
        <translation>erste Schicht</translation>
    </message>
    <message>
        <source>last slice</source>
        <translation>letzte Schicht</translation>
    </message>
    <message>
        <source>shows the whole slice</source>
        <translation>zeigt das ganze Schnittbild</translation>
    </message>
    <message>
        <source>changes the brightness</source>
        <translation>ändert die Helligkeit</translation>
    </message>
    <message>
        <source>changes the contrast</source>
        <translation>ändert den Kontrast</translation>
    </message>
    <message>
        <source>moves the crosshair by a voxel</source>
        <translation>bewegt das Fadenkreuz um ein Voxel</translation>
    </message>
    <message>
        <source>opens the choices for slices</source>
        <translation>öffnet die Auswahl für Schnittbilder</translation>
    </message>
    <message>
        <source>sets a place: at the crosshair, in 3-D in the middle</source>
        <translation>setzt eine Stelle: am Fadenkreuz, in 3-D in der Mitte</translation>
    </message>
    <message>
        <source>picks a piece, sets the clip plane or a corner of the scalpel: at the crosshair, in 3-D in the middle</source>
        <translation>wählt ein Stück, setzt die Trennebene oder eine Ecke des Skalpells: am Fadenkreuz, in 3-D in der Mitte</translation>
    </message>
    <message>
        <source>takes the scalpel&apos;s last corner back</source>
        <translation>nimmt die letzte Ecke des Skalpells zurück</translation>
    </message>
    <message>
        <source>renames the mark, or edits the note</source>
        <translation>benennt die Markierung um oder ändert die Notiz</translation>
    </message>
    <message>
        <source>deletes the mark</source>
        <translation>löscht die Markierung</translation>
    </message>
    <message>
        <source>moves it</source>
        <translation>verschiebt sie</translation>
    </message>
    <message>
        <source>gives the views their first sizes</source>
        <translation>gibt den Ansichten ihre Anfangsgrößen</translation>
    </message>
    <message>
        <source>plays and pauses</source>
        <translation>spielt ab und hält an</translation>
    </message>
    <message>
        <source>one tick back</source>
        <translation>einen Takt zurück</translation>
    </message>
    <message>
        <source>one tick forward</source>
        <translation>einen Takt vor</translation>
    </message>
    <message>
        <source>to the beginning</source>
        <translation>zum Anfang</translation>
    </message>
    <message>
        <source>to the end</source>
        <translation>zum Ende</translation>
    </message>
    <message>
        <source>moves a mark, the crop box or the clip plane</source>
        <translation>verschiebt eine Markierung, die Zuschneidebox oder die Trennebene</translation>
    </message>
    <message>
        <source>sets a place</source>
        <translation>setzt eine Stelle</translation>
    </message>
    <message>
        <source>draws a distance</source>
        <translation>zieht einen Abstand</translation>
    </message>
    <message>
        <source>picks a piece; sets the clip plane; sets a corner of the scalpel, at the last one again: cuts</source>
        <translation>wählt ein Stück; setzt die Trennebene; setzt eine Ecke des Skalpells, noch einmal auf der letzten: schneidet</translation>
    </message>
    <message>
        <source>draws the scalpel&apos;s outline</source>
        <translation>zieht den Umriss des Skalpells</translation>
    </message>
    <message>
        <source>looks from that side</source>
        <translation>blickt von dieser Seite</translation>
    </message>
    <message>
        <source>moves the tool, if the mouse is the hand</source>
        <translation>bewegt das Werkzeug, wenn die Maus die Hand ist</translation>
    </message>
    <message>
        <source>turns the tool, if the mouse is the hand</source>
        <translation>dreht das Werkzeug, wenn die Maus die Hand ist</translation>
    </message>
    <message>
        <source>on the surface: brings the tool there</source>
        <translation>auf der Oberfläche: bringt das Werkzeug dorthin</translation>
    </message>
    <message>
        <source>moves the tool in the plane of the screen</source>
        <translation>bewegt das Werkzeug in der Ebene des Bildschirms</translation>
    </message>
    <message>
        <source>turns the tool</source>
        <translation>dreht das Werkzeug</translation>
    </message>
    <message>
        <source>moves the tool in depth</source>
        <translation>bewegt das Werkzeug in die Tiefe</translation>
    </message>
    <message>
        <source>moves the crosshair</source>
        <translation>bewegt das Fadenkreuz</translation>
    </message>
    <message>
        <source>brings the tool to the surface there</source>
        <translation>bringt das Werkzeug dort an die Oberfläche</translation>
    </message>
    <message>
        <source>brightness (up and down), contrast (left and right)</source>
        <translation>Helligkeit (auf und ab), Kontrast (links und rechts)</translation>
    </message>
    <message>
        <source>moves the isovalue</source>
        <translation>verschiebt den Isowert</translation>
    </message>
    <message>
        <source>moves through the time</source>
        <translation>geht durch die Zeit</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Page Up</source>
        <translation>Bild auf</translation>
    </message>
    <message>
        <source>Page Down</source>
        <translation>Bild ab</translation>
    </message>
    <message>
        <source>Escape and Space stop the force and cannot be changed.</source>
        <translation>Esc und die Leertaste halten die Kraft an und lassen sich nicht ändern.</translation>
    </message>
    <message>
        <source>Tab selects the next control and cannot be changed.</source>
        <translation>Tab wählt das nächste Bedienelement und lässt sich nicht ändern.</translation>
    </message>
    <message>
        <source>A function that works while a key is held needs a single key.</source>
        <translation>Eine Funktion, die wirkt, solange eine Taste gehalten wird, braucht eine einzelne Taste.</translation>
    </message>
    <message>
        <source>This key cannot be changed.</source>
        <translation>Diese Taste lässt sich nicht ändern.</translation>
    </message>
    <message>
        <source>shows the help for the focused control</source>
        <translation>zeigt die Hilfe zum Bedienelement mit dem Fokus</translation>
    </message>
    <message>
        <source>selects the next view</source>
        <translation>wählt die nächste Ansicht</translation>
    </message>
    <message>
        <source>zooms in at the pointer</source>
        <translation>vergrößert beim Zeiger</translation>
    </message>
    <message>
        <source>zooms out at the pointer</source>
        <translation>verkleinert beim Zeiger</translation>
    </message>
    <message>
        <source>shows the place; again: its next one</source>
        <translation>zeigt die Stelle; noch einmal: ihre nächste</translation>
    </message>
    <message>
        <source>zooms in (up) or out (down)</source>
        <translation>vergrößert (hinauf) oder verkleinert (hinunter)</translation>
    </message>
    <message>
        <source>scrolls through the slices</source>
        <translation>blättert durch die Schichten</translation>
    </message>
    <message>
        <source>force off; closes what is open, without motors at first that alone</source>
        <translation>Kraft aus; schließt, was offen ist, ohne Motoren zuerst nur das</translation>
    </message>
    <message>
        <source>moves the tool by 1 mm; Page Up: deeper</source>
        <translation>bewegt das Werkzeug um 1 mm; Bild auf: tiefer</translation>
    </message>
    <message>
        <source>moves the tool by 0.1 mm</source>
        <translation>bewegt das Werkzeug um 0,1 mm</translation>
    </message>
    <message>
        <source>turns the tool by 5 degrees</source>
        <translation>dreht das Werkzeug um 5 Grad</translation>
    </message>
    <message>
        <source>fits the body into the view</source>
        <translation>passt den Körper in die Ansicht ein</translation>
    </message>
    <message>
        <source>grey window: soft tissue</source>
        <translation>Graufenster: Weichteile</translation>
    </message>
    <message>
        <source>grey window: bone</source>
        <translation>Graufenster: Knochen</translation>
    </message>
    <message>
        <source>grey window: lung</source>
        <translation>Graufenster: Lunge</translation>
    </message>
    <message>
        <source>grey window: brain</source>
        <translation>Graufenster: Gehirn</translation>
    </message>
    <message>
        <source>grey window: mediastinum</source>
        <translation>Graufenster: Mediastinum</translation>
    </message>
    <message>
        <source>grey window: temporal bone</source>
        <translation>Graufenster: Felsenbein</translation>
    </message>
    <message>
        <source>grey window: as at first</source>
        <translation>Graufenster: wie zu Beginn</translation>
    </message>
    <message>
        <source>takes level and width as numbers</source>
        <translation>nimmt Zentrum und Breite als Zahlen</translation>
    </message>
    <message>
        <source>%1, while the mouse has the tool (%2)</source>
        <translation>%1, während die Maus das Werkzeug hat (%2)</translation>
    </message>
    <message>
        <source>list of structures</source>
        <translation>Liste der Strukturen</translation>
    </message>
    <message>
        <source>turns the views to the structure</source>
        <translation>dreht die Ansichten zur Struktur</translation>
    </message>
    <message>
        <source>renames the structure</source>
        <translation>benennt die Struktur um</translation>
    </message>
    <message>
        <source>shows the structure, or hides it</source>
        <translation>zeigt die Struktur oder verbirgt sie</translation>
    </message>
    <message>
        <source>turns the burr, which cuts what it is pressed against</source>
        <translation>dreht den Bohrer, der schneidet, wogegen er gedrückt wird</translation>
    </message>
    <message>
        <source>shows the unedited scan beside what is left, or hides it</source>
        <translation>zeigt die unbearbeitete Aufnahme neben dem, was übrig ist, oder verbirgt sie</translation>
    </message>
</context>
</TS>
