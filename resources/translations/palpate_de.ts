<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Messages</name>
    <message>
        <source>There is no hand &quot;%1&quot;; choose one of %2, or a CSV of poses.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The isovalue %1 is at or below the background %2, where everything would be solid; choose a higher one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool is up to %1 mm long, which is unusual; the points are taken to be in metres.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This palpate-cli was built without readers and opens no files; use --phantom, or the desktop build.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no tool &quot;%1&quot;; choose one of %2, or a mesh file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no unit &quot;%1&quot;; choose one of m, mm, cm, in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This palpate-cli was built without readers and opens no mesh files; use a named tool or a CSV of points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be opened; check the path.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first line of &quot;%1&quot; holds numbers, where the columns&apos; names belong, and would be lost; write a line of names above it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; needs %2 numbers, separated by commas, in line %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds a header and no rows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; has a rotation that is no unit quaternion.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; leads the hand further away than 100 m, which no hand goes; its positions are in metres.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not opened: its field &quot;%2&quot; has a value that no view has; use a copy of the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not opened: its field &quot;%2&quot; is missing; use a copy of the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not opened: it has a field that this version of views does not have; use a copy of the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is damaged, or is no view of Palpate&apos;s; views end in .palpate-view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; was saved by an earlier Palpate, in a version of views that this one does not read; use that one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; was saved by a later Palpate; use that one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is larger than 1 MB, and no view is; choose another file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no file that can be read; check the path.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not saved: with so many notes and edits it would be larger than 1 MB; delete some and save again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The measurement was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no scan named %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polhem and WoodenHaptics have the same boards: connect the arm that it is, or it is pushed in wrong directions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No %1 is plugged in; switch its power on and plug its USB cable in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 went away; plug it in again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The board of the %1 has firmware of before October 2019, which is not supported; load a newer one of its makers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is plugged in does not answer as a %1 does; switch its power on, or unplug the other device that has its USB ids.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no device &apos;%1&apos;; `palpate-cli devices` lists those that are known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Novint Falcon was lost while it was opened; plug it in again, best into the computer itself, and open it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No Novint Falcon is plugged in; plug in its USB cable and its power supply.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The system does not let you use the Novint Falcon; install Palpate&apos;s rules for devices, 70-palpate.rules, and plug it in again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Novint Falcon is in use; close the program that has it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Novint Falcon&apos;s firmware file &apos;%1&apos; cannot be read; choose the one that came with the Falcon&apos;s own software.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Novint Falcon&apos;s firmware file &apos;%1&apos; is empty; choose the one that came with the Falcon&apos;s own software.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Novint Falcon&apos;s firmware file &apos;%1&apos; is larger than the Falcon&apos;s memory; choose the one that came with the Falcon&apos;s own software.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Novint Falcon has had no firmware since it was switched on; choose the firmware file that came with the Falcon&apos;s own software.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Novint Falcon does not answer; see that its power supply is plugged in, switch it off and on, and open it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Novint Falcon did not take its firmware whole; plug it into a port of the computer itself, or into a hub with a power supply, and open it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Novint Falcon took &apos;%1&apos;, but does not run it; switch it off and on, and choose the firmware file that came with the Falcon&apos;s own software.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program uses the Novint Falcon; close that program first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Novint Falcon is not plugged in, or not where it was; plug in its USB cable and its power supply.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Novint Falcon could not be opened (%1); unplug it and plug it in again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>install it from its maker&apos;s site, where the system looks for libraries.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Force Dimension SDK is too old (%1 lacks %2); install a newer one from its maker&apos;s site.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Force Dimension SDK is of version %1.%2.%3, and Palpate knows 3.3.2 to 3.x; install one of these from its maker&apos;s site.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Force Dimension device is of model number %1, which Palpate does not know; tell its makers the number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 does not take a watchdog, without which its force would stay on when a program dies; update its firmware.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program uses the Force Dimension device; close that program first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The system does not let you use the Force Dimension device; install Palpate&apos;s rules for devices, 70-palpate.rules, and plug it in again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Force Dimension device is gone; plug it in and switch it on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Force Dimension device does not answer; switch it on, and see that Palpate&apos;s rules for devices, 70-palpate.rules, are installed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Force Dimension device could not be opened (error %1); switch it off and on again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No Force Dimension device is found; plug it in and switch it on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Palpate has a Force Dimension device open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening it tells which model it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Palpate has a Force Dimension device open; close that one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The system does not let you use the %1; install Palpate&apos;s rules for devices, 70-palpate.rules, and plug it in again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program, or another part of Palpate, uses the %1; close that one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 is gone; plug it in again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The %1 could not be opened; unplug it and plug it in again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Haply Inverse3 has no power; plug in its power supply.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Haply Inverse3 is not started; switch it off and on, and wait.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Haply Inverse3 is not ready; wait, or switch it off and on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Haply Inverse3 is not calibrated; put its handle in the inkwell until its light says that it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The service of the Haply Inverse3 does not answer; install and start its maker&apos;s haply-inverse-service.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The service of the Haply Inverse3 speaks in a way that Palpate does not know; install version 3.5 of haply-inverse-service.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No Haply Inverse3 is connected; plug in its cable and its power supply, and look for it in Haply Hub.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Haply Inverse3 %1 is set to other axes than its maker&apos;s; set its basis to XYZ in Haply Hub.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>install it and the device&apos;s driver from 3D Systems&apos; site, where the system looks for libraries.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenHaptics is too old (%1 lacks %2); install a newer one from 3D Systems&apos; site.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program uses the Touch or PHANTOM; close that program first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenHaptics finds no valid licence; run its licence tool, or install the developer edition from 3D Systems&apos; site.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The Touch or PHANTOM does not answer; see that it is plugged in and switched on, that Palpate&apos;s rules for devices, 70-palpate.rules, are installed, and pair it in the maker&apos;s setup tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenHaptics finds no Touch or PHANTOM; plug it in, switch it on, and set it up with the maker&apos;s setup tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenHaptics could not open the Touch or PHANTOM (error %1); try the maker&apos;s diagnostic tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Palpate has a Touch or PHANTOM open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenHaptics is installed; opening tells whether a device is there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Palpate has a Touch or PHANTOM open; close that one first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 cannot be loaded (%3); %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not installed (looked for %2); %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No SpaceMouse is plugged in; plug it or its receiver in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The service spacenavd does not answer at &apos;%1&apos;; start it, or use the SpaceMouse without it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The system does not let you use the service spacenavd at &apos;%1&apos;; let your user read and write that socket.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written (%2); choose a folder that can be written and has room.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no regular file, and is not written over; name a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The volume is not the one that was recorded: its voxels are others, or lie elsewhere; give the one that was touched, or none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; names a folder; add how the files&apos; names begin, such as sub-01_task-touch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording goes from %1 s to %2 s and holds no step%3%4%5; choose others.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> from %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> to %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> at %1 Hz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording is damaged: its time goes backwards; use a copy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped; nothing was exported.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The film was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ffmpeg ended before the film was whole; check the room on the disk, and that ffmpeg has libx264.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ffmpeg ended before the film was whole (%1); check the room on the disk, and that ffmpeg has libx264.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be written; check that its folder exists, may be written to and has room.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording has no step in that stretch of time; choose another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The film would have more than a million frames; take a shorter stretch, or a greater speed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A film&apos;s width and height are even numbers of 64 to 7680 pixels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A film has 1 to 240 frames a second.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A film&apos;s speed is 0.001 to 1000 times that of the session.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no X display to draw a film on; set DISPLAY, or where there is no screen put &quot;xvfb-run -a&quot; before the command.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This display has no OpenGL 3.2, which a film is drawn with; use another, or put &quot;xvfb-run -a&quot; before the command.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The film could not be written; check the room on the disk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no host and port; write it as pacs.example.org:104.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name one server: --dicomweb with a URL, or --dimse with host and port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A server of DIMSE has an AE title; name it with --called.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A login belongs to DICOMweb; DIMSE knows this program by its AE title, and by its certificate with --tls.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>--called, --tls and --move belong to DIMSE; a server of DICOMweb has a URL alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A certificate needs its private key: give --certificate and --key.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name a new folder for the images with --out; without one, a parent program must hold standard input (--attached).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The URL of a server of DICOMweb is https:// or http:// with a host and a path, without user, password and query.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The login was not sent to &quot;%1&quot;: without https everybody between could read it; use the server&apos;s https address.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard input has no login; give {&quot;login&quot;: {&quot;user&quot;, &quot;password&quot;}} or {&quot;login&quot;: {&quot;token&quot;}}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard input is no JSON object; give one such as {&quot;query&quot;: {&quot;patient_id&quot;: …}}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard input has a field that is unknown or has a wrong value: &quot;%1&quot;; palpate-fetch&apos;s README lists them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The query is empty, and a search for everything is not made; give a patient, an accession number, a date or a description.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the index of a series, as find lists them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an empty folder of yours; name a new one for the images.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no numeric address; give the one at which the server reaches this machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C-MOVE with TLS needs a certificate of this machine, since the server connects to it; give --certificate and --key.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no certificate that can be read (PEM).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no private key that can be read (PEM), or its passphrase is another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The desktop&apos;s keyring does not answer; unlock it, or log in with --login basic.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The keyring has no entry for %1; store one, or log in with --login basic.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped; nothing of the transfer was kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The transfer could not be started; close other programs and try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server&apos;s answer needs more memory than a transfer may take; search more narrowly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server was not done after %1 s, and the transfer was ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The transfer ended by itself: what the server sent cannot be read, or needs more memory or time than allowed. Nothing was kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images cannot be written to &quot;%1&quot;; look whether the disk is full.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The host of &quot;%1&quot; is not known; check its name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The host of &quot;%1&quot; does not answer; check its address, the network and the firewall.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The host of &quot;%1&quot; refuses the connection: no server listens at this port; check the port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What listens at &quot;%1&quot; does not answer as a web server does; check the port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What listens at &quot;%1&quot; closed the connection without an answer; check the port, and whether the server wants TLS.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TLS could not be set up with &quot;%1&quot;; check the port, and whether the server has TLS there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TLS could not be set up on this machine; install Palpate again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The certificate of &quot;%1&quot; has expired or is not valid yet; check this machine&apos;s clock, and tell the server&apos;s administrator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The certificate of &quot;%1&quot; is for another host; check the host&apos;s name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The certificate of &quot;%1&quot; is from an authority that this machine does not know; get the authority&apos;s certificate from the administrator and give it with --authority.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The certificate of &quot;%1&quot; is not valid; tell the server&apos;s administrator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; wants a certificate of this machine; give --certificate and --key.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; refuses this machine&apos;s certificate; ask the administrator for one that it trusts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; sends this program to another host or in a circle, which is not followed; use the server&apos;s own URL.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; wants a login; give one with --login.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; refuses the login; check user and password, or the token.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not permit this; ask its administrator for permission to search and retrieve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no DICOMweb at &quot;%1&quot;; check the path of the URL, such as /dicom-web.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not have the AE title &quot;%2&quot;; ask its administrator for the server&apos;s title.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not know this program&apos;s AE title &quot;%2&quot;; ask its administrator to add it, or give one that it knows with --calling.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; rejects the association from &quot;%3&quot; to &quot;%2&quot; without a reason; ask its administrator whether both AE titles are known to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; takes no more associations for now; try again later.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not permit &quot;%2&quot; an echo; ask its administrator for permission.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; ended the association at the first request: it does not know &quot;%2&quot; or does not permit it to search; ask its administrator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not permit &quot;%2&quot; to search; ask its administrator for permission.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; offers no C-GET to this program; ask its administrator for permission, or switch C-MOVE on for it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; offers no C-MOVE to this program; ask its administrator for permission.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; does not know where to send images for &quot;%2&quot;; ask its administrator to enter this program&apos;s AE title with its address and port.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be listened on: %2; give an address of this machine and a port that is free.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; answers, and lets this program search.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; was silent for %2 s, and the transfer was ended; try again later.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; sends less than %2 bytes a second, and the transfer was ended; try again later.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The connection to &quot;%1&quot; was lost; try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server&apos;s answer was cut off; try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; answered with HTTP status %2; ask its administrator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; answered with DIMSE status %2 (hexadecimal); ask its administrator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; answered with a message that has no place there; ask its administrator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; sent a message that is longer than any it was asked for; ask its administrator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; packed its answer although it was asked not to; ask its administrator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server&apos;s answer is no multipart message as DICOMweb has them; ask its administrator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server&apos;s answer is no list as DICOMweb has them; check the path of the URL.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server&apos;s answer is too long; search more narrowly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; finds too much; search more narrowly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More than %1 studies match; search more narrowly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More than %1 series match; search more narrowly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More than %1 entries match; search more narrowly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 entries have no identifier as DICOM has them, and were left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no series %1: %2 match.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server&apos;s list has changed, and the index names another series now; search again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; answered with something else than images; ask its administrator.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; sent images of another series than was asked for, and none of them was kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server sent more than %1 files that were not asked for, and the transfer was ended.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 images of other series were sent although they were not asked for, and were not kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; sent files that are not DICOM, and none of them was kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 files that are not DICOM were sent, and were not kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; sent no image of the series; ask its administrator for permission to retrieve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 images that the server lists did not come.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The series has more than %1 images, and none was kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The series is larger than %1 GiB, and none of it was kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is cut off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more data follows its end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its %1 has %2 components, not one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its %1 has %2 pixels and the header says %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its %1 has values of %2 bits and the header says %3 of %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its %1 bytes are too few for %2 pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its Huffman tables are no code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it maps its values through a table or states its size twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its coding parameters contradict each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is coded by another JPEG process than its transfer syntax names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its values have a depth that JPEG does not know</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its frame header is senseless</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its coded data come before its size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its scan header is senseless</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is coded with loss and its transfer syntax is lossless</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it does not begin like JPEG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it states its size twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a marker stands in its header that has no place there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its coded data are broken off by another marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its JPEG 2000 image and the header differ on whether values have a sign</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is coded as High-Throughput JPEG 2000</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its pixels lie on another grid than an image&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has more tiles than JPEG 2000 knows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its coding style is senseless</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its tiles do not follow each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it does not begin like a JPEG 2000 codestream</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its main header is incomplete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its RLE table has %1 segments where %2 bits need %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its RLE table is senseless</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its transfer syntax is not known here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has %1 pixels, more than any slice does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compressed images are decoded by the program %1, which is not installed; install Palpate again, or export the images as explicit little endian.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compressed images are decoded by the program %1, which could not be given memory; install Palpate again, or export the images as explicit little endian.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compressed images are decoded by the program %1, which could not be connected; install Palpate again, or export the images as explicit little endian.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compressed images are decoded by the program %1, which could not be started; install Palpate again, or export the images as explicit little endian.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compressed images are decoded by the program %1, which could not be confined to its work on this system; install Palpate again, or export the images as explicit little endian.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The compressed pixels of %1 are damaged or cut off; fetch the file again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file %1 states a %2 that is not written as DICOM writes numbers (&quot;1.5&quot;, with a point and without a unit), or too many or too few of them; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images are stored in a transfer syntax (that is not known here) that cannot be decoded; export them as explicit little endian.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images are stored in a transfer syntax (%1) that cannot be decoded; export them as explicit little endian.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file %1 was copied as if it were text, which put bytes among its pixels; copy it again in binary mode.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file %1 goes on after its pixels with something that is no DICOM; copy or fetch it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A file of the series describes an image and ends without its pixels; fetch it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The series holds no image (modality not stated); choose the series of the scan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The series holds no image (modality %1); choose the series of the scan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The series holds colour pictures, which have no isosurface; choose the series of the scan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file %1 ends before its pixels do; copy or fetch it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file %1 states %2 frames, more than any scan has; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file %1 states a number of pixels or bits that no image has; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A file of the series holds more pixels than the slices it states; export it again, as one file per slice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The series is a scout view for planning and no stack of slices; choose the series of the scan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pixels of %1 are stored in another way than its transfer syntax says; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A file of the series states %1 x %2 pixels of %3 bits, which is not an image that can be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The series does not say where its slices lie (position, orientation or pixel spacing is missing); export it again with its geometry.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file %1 maps its stored values through a table (Modality LUT), which is not done here; export it with a rescale slope and intercept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file %1 states one of rescale slope and intercept without the other; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file %1 states a rescale slope of 0; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file %1 does not say whether its pixels have a sign (Pixel Representation); export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file %1 states %2 stored of %3 bits, up to bit %4, which cannot be; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 is damaged or cut off; copy or fetch it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 cannot be understood; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%(1) (%2 of %3 files).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The series mixes voxel types; put them into folders of their own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The series holds several acquisitions whose slices lie between each other&apos;s, and it cannot be told which belong together; put each acquisition into a folder of its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no DICOM file, or not any more; open the folder of one series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds no image: it is the index of a folder, or no DICOM after all; open the folder of one series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The largest part without a gap has %1 of the %2 slices that are there, from %3 to %4 mm along the stack.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One evenly spaced stack of %1 slices.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A single slice, taken to be as thick as it states.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A single slice of unstated thickness, taken to be 1 mm thick.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%(1); 1 other copy of a slice in the folder is left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%(1); %2 other copies of slices in the folder are left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pixels of %1 cannot be decoded: they are cut off, damaged or in a form unknown here; fetch the file again or export it as explicit little endian.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The compressed image in %1 cannot be shown: %2; fetch the file again or export it as explicit little endian.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The compressed image in %1 is damaged in a way that its decoder does not bear; fetch the file again or export it as explicit little endian.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A series that is to be resampled is read whole or not at all; free memory by closing other programs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The series&apos; rescaled values fit no voxel type; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is or inflates to more than a scan&apos;s file should; export it uncompressed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The compressed data of %1 end early or are damaged; copy or fetch it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read; copy or fetch it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A slice of the series has a position or pixel spacing that is no positive number; export the series again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A slice of the series has an orientation that is not two perpendicular directions; export the series again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The series mixes slices of %1 x %2 and %3 x %4 pixels; put them into folders of their own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The series mixes slices that are turned against each other by up to %1 degrees; put each orientation into a folder of its own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The series mixes pixel spacings of %1 and %2 mm; put them into folders of their own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 slices lie at the position of another one; keep one image of each position in the folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The slices advance %1 degrees off the direction that they face, which no gantry does; export the series again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A slice of the series lies %1 mm beside the others; ask for a reconstruction as one straight stack.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 slice is missing from the series (%1 of %2 steps are a multiple of %3 mm); fetch the series again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 slices are missing from the series (%2 of %3 steps are a multiple of %4 mm); fetch the series again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The slices are unevenly spaced: %1 of %2 steps differ from %3 mm, from %4 to %5 mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The slices are tilted by %1 degrees against the direction in which they advance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The slices are tilted by %1 degrees against the direction in which they advance, and unevenly spaced.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%(1); there are too few of them to fill the gaps, so ask for a reconstruction with even spacing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%(1), and lie %2 pixels beside each other, which no scan does; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%(1); they can be resampled onto a right-angled grid of even steps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The series holds no slice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 nests more sequences, or has more elements out of order, than any scan&apos;s, or cannot be understood; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The archive %1 holds more than a study, or more than the disk for temporary files has room for; unpack it yourself and open the folder of one series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The archive %1 is cut off or damaged; copy or fetch it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The archive %1 is locked with a password; unpack it yourself and open the folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The archive %1 holds a name that leads out of it or too deep into it; unpack it yourself and open the folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder for temporary files, &quot;%1&quot;, cannot be written, and an archive is unpacked there; set TMPDIR to one that can be, or unpack the archive yourself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header %1 names a data file outside its own folder; put both into one folder and name it without a path.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The data file that %1 names is missing; copy it beside the header.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The volume has an axis without voxels; its header is broken.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The volume&apos;s spacing, orientation or origin is not a number; export it again with its geometry.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The volume&apos;s voxel spacing of %1 x %2 x %3 mm cannot be right; export it again with its geometry.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The volume is said to lie %1 m away from the origin of its space, which cannot be right; export it again with its geometry.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The volume&apos;s axes are %1 degrees off their right angles; resample it onto a right-angled grid first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder %1 holds more than %2 files; open the folder of one study.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be opened without loading it whole; copy it to a disk of this machine, or read a part of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is too short for its voxels; copy or fetch it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every %1th voxel is none; take every second, say.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The box from %1 to %2 lies outside an axis of %3 voxels; choose one inside.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no file or folder %1 that can be read; check its name and its permissions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loading was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>close other programs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The volume needs %1 GB of memory and %2 GB are free; read every second voxel or a box of it, or %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>save it raw with a detached header</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>save it with numbers in every voxel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states a size that is no positive number; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states more voxels than any memory holds; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds %2 volumes; export fewer than %3 into one file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is too short for the voxels that its header states; copy or fetch it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The voxels of %1 end early or are damaged; copy or fetch the file again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The slice has no size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A vertex of %1 is not a finite number; export the mesh again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A vertex of %1 is not three numbers; export the mesh again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 begins a facet inside a facet; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A facet of %1 has %2 vertices and not three; export the mesh again as triangles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ends before its solid does; copy it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ends within its header; copy it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 states %2 triangles and has room for %3; copy or export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face %1 of %2 has fewer than three corners or names a vertex that the file does not have; export the mesh again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 is not one of a PLY file; export the mesh again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ends before its %2 rows of an element do; copy or export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A face of %1 has fewer than three corners or names a vertex that the file does not have; export the mesh again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not a mesh that can be read; save the tool as STL, OBJ or PLY.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is larger than 1 GB; reduce the mesh first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The memory of this machine does not hold %1; reduce the mesh first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read as a mesh; export it again as binary STL.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds no triangle; a tool needs a surface, so export one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mesh is open (%1 edges have one triangle); it is touched with its vertices all the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mesh is not manifold (%1 edges have more than two triangles); it is touched with its vertices all the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool is %1 mm long, which is unusual; check the unit of the mesh.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 is longer than 1 MB; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 has a line that is no key and value; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states a field twice; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 names no data file; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states no ElementType; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The voxels of %1 are colours or vectors; export a volume of one value per voxel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The voxels of %1 are 64-bit integers, which cannot be shown or touched exactly; convert them to 32-bit integers or float.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states an unknown ElementType; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states no NDims; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has %2 axes; export a volume of three.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 does not state a size of each axis; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 does not state %2 numbers as its %3; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 measures in a unit that is no length known here; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states a spacing that is not positive; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states directions that are no unit vectors; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 rescales its voxels by a slope that makes no sense; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The voxels of %1 are text and no bytes; save them as binary data.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The voxels of %1 are spread over several files; save them as one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states a HeaderSize that makes no sense; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states a HeaderSize that ends within it; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 says nothing of the %2 bytes that its data file holds beside the voxels; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states a size of its voxels that is not that of their type; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The voxels of %1 are colours or complex numbers; export a volume of one value per voxel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The voxels of %1 are of a type that cannot be shown or touched exactly; convert them to 32-bit integers or float.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states a number of axes that makes no sense; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis %1 of %2, counted from 1, holds the components of vectors and no places; export a volume of one value per voxel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 places the voxels where none can be; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states an orientation that is no rotation; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 places the voxels twice, by its qform and by its sform, and not alike; export it with one of them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 rescales its voxels by what is no number; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 does not begin as that of a NIfTI file in one piece; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states no type; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The voxels of %1 are blocks of bytes and no numbers; export a scalar volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states an unknown type; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis %1 of %2, counted from 0, is of kind %3 and holds no places; export a volume of three axes and one value per voxel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 does not state a kind of each axis; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 calls %2 of its four axes places, by direction or by kind; export it with three of them and one that counts volumes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states no dimension; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The dimension of %1 is %2; only volumes of three axes and one value per voxel can be loaded, one or several in a file, so export one such volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states no sizes; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states no encoding; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The voxels of %1 are in an encoding that is unknown here; save them as raw or gzip.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 does not state the byte order; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 skips a number of lines or bytes that makes no sense; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ends with its header; fetch it again whole.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 names its data files in a way that cannot be followed; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The data file of %1 holds %2 bytes more than its voxels need and the header does not say which; add a byte skip to the header.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is too short for the %2 voxels that its header states; copy or fetch it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 does not begin with NRRD0001 to NRRD0005; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 lists too many files; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 has a field that is too long; export it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 measures its axes in a unit that is no length known here; export it in millimetres.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 measures its axes in different units; export it in millimetres.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An axis of %1 has no direction in space; export it again with its geometry.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 states spacings that do not lead from its axis mins to its axis maxs; export it again with its geometry.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 does not state the spacing of every axis; export it again with its geometry.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The header of %1 cannot be understood; export the volume again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ends within what its header says to skip; copy or fetch it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Voxel %1 of %2 is written as something that is no value of its type; export it again as raw.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No NRRD file has been read yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One evenly spaced stack.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file does not state its orientation: left and right are unknown, and its spacing is taken to be in millimetres.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file states neither orientation nor spacing: left and right are unknown, and voxels of 1 mm are assumed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file states no spacing: voxels of 1 mm are assumed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume %1 of %2, counted from 0. %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The memory of this machine does not hold %1; close other programs or try a smaller series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read; copy it to another folder and try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2, %3, %4 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2, %3, %4 mm, correctable (%5)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2, %3, refused (%4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of no modality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; and %2 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no series %2: %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds %2 series that can be loaded; name one: %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None of the %1 series in %2 can be loaded; the first: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder holds more volumes than can be listed; open this file by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 empty file lies beside the slices; if the series lacks some, copy it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 empty files lie beside the slices; if the series lacks some, copy it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 damaged DICOM file lies beside the slices and may be one of them; copy the folder again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 damaged DICOM files lie beside the slices and may be one of them; copy the folder again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 file beside the slices may not be read; if the series lacks some, change their permissions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 files beside the slices may not be read; if the series lacks some, change their permissions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder %1 holds no scan that is known here (DICOM, NRRD, MetaImage or NIfTI); open the folder of a series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The archive %1 holds no scan that is known here (DICOM, NRRD, MetaImage or NIfTI); open the folder of a series.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 may not be read by this user; change its permissions or copy it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no DICOM, NRRD, MetaImage or NIfTI file; open the folder of a DICOM series, one of its files, or an .nrrd, .nhdr, .mhd, .mha, .nii or .nii.gz file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A part of the recording is damaged and cannot be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording could not be finished: %1. It stays &quot;%2&quot; and can be recovered once there is room.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording could not be finished: the file is damaged. It stays &quot;%1&quot;; look at the disk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was recorded: no tick came meanwhile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no memory left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording stopped, and touch goes on: %1. Nothing was recorded until then.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording stopped, and touch goes on: %1. What was recorded until then is in &quot;%2&quot; and can be recovered once there is room.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording stopped, and touch goes on: %1. What was recorded until then is in &quot;%2&quot; and can be recovered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be recorded to (%2); choose a folder that can be written and has room.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is what an earlier recording left; recover it with palpate-cli recover, or remove it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be recovered: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be recovered: its name does not end in .part.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be recovered: there is no such file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be recovered: it is being written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be recovered: it is no recording.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be recovered: nothing was recorded yet; remove it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording is damaged and cannot be read; use a copy of it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; holds no step; nothing was recorded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; was never finished; palpate-cli recover brings back what is in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be opened; check its permissions.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no recording of Palpate&apos;s; recordings end in .palpate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; was recorded by a later Palpate; use that one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was taken away from the scan in the recording comes out otherwise here: the scan or this version of Palpate is another; replay with the version that recorded it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The replay was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the recording says of its scene is damaged; nothing can be replayed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the recording says of a start is damaged; nothing can be replayed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is no regular file, and a recording needs one; name a file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The key of this installation, &quot;%1&quot;, cannot be used (%2); volumes of recordings are not recognised until it can.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The key of this installation, &quot;%1&quot;, is damaged; put it back from a copy. Or remove it, for a new one: then no volume of an earlier recording is recognised any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no phantom named &apos;%1&apos;; known phantoms are %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The volume needs %1 MB of memory, which this machine does not give; try a smaller series or close other programs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The volume has an axis without voxels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The volume&apos;s voxel spacing is not a positive number; its header cannot be used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The volume&apos;s position or orientation is not a number; its header cannot be used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The volume&apos;s axes are not at right angles; only right-angled stacks can be loaded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the volume was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The volume holds no finite voxel; there is nothing to see or touch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was taken away from the scan is stored in a way that cannot be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edit was cancelled; the scan is as it was.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edit would take nothing away; choose another place or isovalue.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no solid at the place; point at the surface, or lower the isovalue.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No table or holder was found beside the patient; take it away with the lasso or as a piece.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The crop box reaches beyond the scan; draw it within.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scan&apos;s voxels cannot be edited in memory; load the scan again from its file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is too little memory for the edit, and the scan is as it was; close other programs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scan has %1 edits, and no more are kept; reset some first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no edit to undo.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no edit to redo.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no volume to touch; open one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool has no points; a tool needs at least one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the scene was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to touch yet; open a volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool would start inside the solid, with no room within 50 mm; raise the isovalue.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool starts inside the solid and there is no room for it within 50 mm; start the hand outside or raise the isovalue.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The hand has no poses.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The hand&apos;s row %1 holds something that is not a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The hand&apos;s time does not increase at row %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing in the volume reaches the isovalue %1; choose a lower one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool finds no surface at the isovalue %1; choose a lower one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool has a point that is not a number; mend the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool has a point more than 10 m from its middle, and no hand holds that; check its unit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool &quot;%1&quot; has a triangle without vertices.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool &quot;%1&quot; has no triangle to spread points over.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no tool named &apos;%1&apos;; known tools are %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QMessageBox</name>
    <message>
        <source>Read a part of it?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A part of it can be read instead. The files stay as they are.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>Save picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3-D view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slice: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1x, %2 by %3 pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::Application</name>
    <message>
        <source>No program here shows folders. The file is in &quot;%1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another hand was chosen: the device was disconnected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The measurement was cancelled: another hand took the device.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The measurement was cancelled: a recording is being replayed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A recording was opened: the device was disconnected.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::DeviceController</name>
    <message>
        <source>Haptic device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Haptic device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 will be connected when there is something to touch: open a scan, or try the demo skull.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the force was taken away. %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::DeviceWatch</name>
    <message>
        <source>The device could not be opened: its driver failed. Unplug it, plug it in and try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This Palpate was built without drivers of haptic devices.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::EditController</name>
    <message>
        <source>%1 cm³</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the &amp;way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the last edit back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes the edit again that was taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take &amp;all edits back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Crop box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clip &amp;plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;ieces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table and &amp;holder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Scalpel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All pieces smaller than %1: together %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table and holder: %1 would go.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This piece: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Millimetres along the patient&apos;s axes, from the scan&apos;s origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Millimetres along the scan&apos;s own axes, from its first voxel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No slice is in view to crop to; show the slices, or set the box by its numbers.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no surface inside the outline to measure the depth from; draw it over the surface, or cut through everything.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory to show this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A volume is being saved; wait for it, or cancel it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; was saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory to save this volume.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; belongs to the scan that is open, and is not written over; choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::EditQueue</name>
    <message>
        <source>Editing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo waits until the tool no longer touches.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo waits until the tool no longer touches.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taking all edits back waits until the tool no longer touches.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This edit puts material back, and waits until the tool no longer touches.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for this edit; nothing was changed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edit could not be made: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture of the edited volume could not be made: it shows the volume before the edit, and is not what is touched. Close other programs and undo the edit.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::ExportController</name>
    <message>
        <source>This film may show a face.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At this isovalue the skin is drawn, and skin can be a face that somebody knows. Raise the isovalue to bone, or give the film only to those who may see it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Film (*.mp4 *.ogv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An export of that name is there already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its files are written over.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write over it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An export is under way; wait for it, or cancel it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::ExportTask</name>
    <message>
        <source>&quot;%1&quot; was exported.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for this export; choose a shorter time.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::Film</name>
    <message>
        <source>%1 s   %2 N</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::HandController</name>
    <message>
        <source>Mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated: tap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated: slide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated: wedge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated: pry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated: hook</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated: jerk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated: twist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hand and tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hand and &amp;tool</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::IsosurfaceController</name>
    <message>
        <source>Surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isos&amp;urface</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::Loader</name>
    <message>
        <source>Loading was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>There is no series %1 in &quot;%2&quot;: it holds %n, counted from 0.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>None of the %n series in &quot;%1&quot; can be loaded.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>&quot;%1&quot; holds %n series; choose one of those that can be loaded.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>This series needs %1 of memory and %2 are free; close other programs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>series %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2 of %3 slices)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (resampled)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (every %2 voxel)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (a box)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to load.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no unit &quot;%1&quot;; choose one of m, mm, cm, in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The isovalue is %1 instead of %2: this volume goes from %3 to %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 voxels were not numbers and count as background.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 voxels are padding, where nothing was measured, and count as air.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no room for the tool near this volume at this isovalue; try a smaller tool or another isovalue.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for this volume and tool; close other programs or take a smaller one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It could not be loaded: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::MarksController</name>
    <message>
        <source>Measures and marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measures and marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Way of the tool from here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for the tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool has travelled %1 since the start, %2 in a straight line.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::Measurement</name>
    <message>
        <source>There is not enough memory for tools of so many points; close other programs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It could not be measured: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::MeasurementController</name>
    <message>
        <source>Performance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Performance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The measurement was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The measurement was cancelled: something else is being loaded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touched with %1 at the isovalue %2, %3 N/m: simulated hands slid, tapped, hooked and wedged, on one thread of ordinary priority. Carried is what keeps the tool, on average, within %4 of a voxel of where ticks without a budget would bring it, with at most one tick in a thousand longer than its period.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::OpeningController</name>
    <message>
        <source> The tool is still %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool &quot;%1&quot; was not taken. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; was not opened. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Still shown: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the phantom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preparing the tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 things are not files of one folder: only the first, &quot;%2&quot;, is opened; open the folder that holds them all to choose among its series.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::PacsController</name>
    <message>
        <source>Scans from a PACS need palpate-fetch, a program of its own, which is not installed; fetch the scan with another program and open its folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asking the server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server answers, and lets Palpate search.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Searching</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server has no series that match.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 series match.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fetching</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 images were fetched and are opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>palpate-fetch ended without an answer; try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>palpate-fetch cannot be started; install it again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::RecordingController</name>
    <message>
        <source>Recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recor&amp;ding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The label was not kept: Palpate&apos;s own folder cannot be written; check its permissions and the room on its disk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a recording in the list on the tab Record; then it can be exported.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording &quot;%1&quot; was never finished. View &gt; Recording lists it: Recover brings back what is in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another window is writing this recording; stop it there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording could not be deleted; check the permissions of its folder.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::Recordings</name>
    <message>
        <source>&apos;%1&apos; is not a folder; choose one that exists.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing can be written to &apos;%1&apos;; choose a folder with room that you may write to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>(cannot be read)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::ReplayController</name>
    <message>
        <source>that one has %1, this one %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both have %1 at the same place, but the voxels differ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both have %1, but they lie at other places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The volume on view is not the one that was touched: %1; open that one to see it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::SeriesChoice</name>
    <message>
        <source>Only these slices are then seen and felt, as they are; of what lies beyond the gaps nothing is shown. The files stay as they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load the largest unbroken part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is seen and felt is then interpolated between the scan&apos;s own slices. The files stay as they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resample and load</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::SessionRecording</name>
    <message>
        <source>The last recording is being finished; try again in a moment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The session was recorded: &quot;%1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording could not be finished: there is no memory left. It can be recovered.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::ToolController</name>
    <message>
        <source>As scanned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preparing the tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preparing the field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smoothing erases %1 % of this solid and adds %2 %: what is felt is not all that is seen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drilling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Burr, 2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Burr, 4 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Burr, 6 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hand drill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straight probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curved probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hook</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Elevator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Needle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trial shapes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrench</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peg</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::ViewController</name>
    <message>
        <source>The tool shows a recording; close the replay to move it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no surface within 30 mm of this place; lower the isovalue, or choose another place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool does not fit there: it stays where it is. Choose a smaller tool, or a place with more room.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This picture may show a face.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slices show the skin, and a profile can be a face that somebody knows. Take a picture of the 3-D view alone at the isovalue of bone, or give this one only to those who may see it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At this isovalue the skin is drawn, and skin can be a face that somebody knows. Raise the isovalue to bone, or give the picture only to those who may see it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The graphics cannot draw a picture of this size; choose a smaller one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&apos;%1&apos; was not written; choose a folder with room that you may write to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture was saved as &quot;%1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture of the 3-D view was copied.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::ViewFileController</name>
    <message>
        <source>The view was not saved: it was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not opened: a recording is on view; close it first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparing the scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not opened: it belongs to another scan. The one on view has the same geometry, %2, but other voxels; open the other scan first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is %1 a view of this scan?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was saved by another installation, so its scan cannot be recognised. The geometry is the same: %1. Marks of another scan would lie in wrong places.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open it over this scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not opened: it has edits of the scan, which this Palpate cannot make.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The isovalue of %1, %2, is none of this scan; %3 is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool of %1 is not known here; the present tool stays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is on view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The one on view has %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The one on view lies elsewhere or is turned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not opened: it belongs to a scan of %2. %3; open the other scan first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They are lost when the window closes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They are lost when another scan is opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They are lost when a view with other edits is opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marks of other scans that were on view are in no file (%1). To save them, open the scan again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The marks and edits of this scan are in no file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The marks of this scan are in no file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The edits of this scan are in no file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no view to save; open a scan first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the view as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Views (*.palpate-view)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes are saved as you wrote them: do not name the patient.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remember where the scan lies, relative to this file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The names of its folders are then in the file. Without it, the scan must be on view to open the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The view was saved as %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::background::Task</name>
    <message>
        <source>The system has no thread left for this; close other programs and try again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for this; close other programs and try again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::exporting</name>
    <message>
        <source>CSV (Motion-BIDS)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables as text, laid out as Motion-BIDS asks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion-BIDS: files that begin with this name (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HDF5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One file of arrays, for programs that compute.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HDF5 (*.h5)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MCAP</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One file of messages over time, for viewers of robots&apos; logs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MCAP (*.mcap)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>app::geometryWords</name>
    <message>
        <source>%1 x %2 x %3 voxels of %4 x %5 x %6 mm (%7)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::Banner</name>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::BoxDialog</name>
    <message>
        <source>2nd</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3rd</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1th</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which voxels to read, counted from 1:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read the box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each end is a whole number within its axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last voxel of an axis comes before its first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %2 × %3 voxels: %4 of memory, %5 are free.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %2 × %3 voxels: %4 of memory, too much for the %5 that are free.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read every second voxel (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read every %1 voxel (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a box…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::ClipPlane</name>
    <message>
        <source>The three places lie on one line, which gives no plane; click three others.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a handle: shifts or turns the clip plane. Escape: ends.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click, or Enter at the crosshair, three times: places the clip plane.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::Colouring</name>
    <message>
        <source>Bone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Airway</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vessels with contrast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::CropBox</name>
    <message>
        <source>Drag a handle: moves a face of the crop box. Escape: ends.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::DevicePanel</name>
    <message>
        <source>Stiffness in N/m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who holds the tool: the mouse, or a simulated hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The spring between hand and tool: stiff is hard, soft is yielding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness, typed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The spring between hand and tool, as a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> N/m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much the surface holds a tool that slides along it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the surface is made from the voxels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meshes (*.stl *.obj *.ply);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::EditPanel</name>
    <message>
        <source>Choose what takes away what is in the way. The file never changes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps what is inside a box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cuts along a plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pieces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps or removes connected pieces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removes table and head holder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scalpel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cuts along an outline that you draw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes all edits back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the last edit back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Makes the edit again that was taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaves everything as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the box ends on this side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crop to view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The box that the slices show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the crop away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps what is inside the box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lays the plane into this slice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction of the cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slope of the cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the middle of the scan, towards what goes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where what goes lies: 0° to L, 90° to P, 180° to R, −90° to A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where what goes lies: 90° to S, −90° to I</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the other side of the plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Places the plane anew, with three clicks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cuts along the plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Towards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Raised</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From slice:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smallest piece that stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> cm³</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pieces of a smaller volume go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the small pieces before they go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click on a piece, in 3-D or in a slice. A piece is what hangs together at the present isovalue.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All pieces smaller than</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show table and holder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows what would go, with its volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finds table and head holder by rule, and shows them before anything is taken away. Look whether it is all holder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth of the cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>through everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In 3-D from the nearest surface inside the outline; in a slice to both sides. 0 cuts through everything.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which side of the outline goes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is inside goes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is outside goes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw an outline with the left button, in 3-D or on a slice. It cuts when you let go. Or click its corners; the last one twice.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep only this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removes all but the piece that is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removes the piece that is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removes what is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaves what is shown where it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face %1 of the box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click three places on the surface: what is nearer to you goes. Or three in one slice: two on a line, and the third on the side that goes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One place is set: click two more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two places are set: click the third, in a slice on the side that goes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n edit(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ui::ExportDialog</name>
    <message>
        <source>every step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With the contacts of each step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write force and time into the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export a recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the recording becomes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the export begins, by the time of the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the export ends, by the time of the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asks for the file, then writes it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes every tick of the servo loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes so many samples a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At a rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Hz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples for each second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes where the tool touches, too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From where the film is seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as it was recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fixed, as it is now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pixels of the film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures for each second of the film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The film then shows the force and the time in figures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A film of the 3-D view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is not a number that can be taken here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The end does not come after the beginning.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of it: %1 (minutes and seconds)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A part of it: %1 (minutes and seconds)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 pictures</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::ForcePanel</name>
    <message>
        <source>Nothing is touched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touching at one place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touching at %1 places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torque</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mN·m</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::ForcePlot</name>
    <message>
        <source>Force over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>force to %1 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>torque to %1 mN·m</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::ForceWords</name>
    <message>
        <source>The device has not told yet where it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device does not know yet where it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is something new to touch, or nothing yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The isovalue left the tool inside the solid; it is being brought out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The clutch is held.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The button or key that has to be held for a force is not down.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There was a gap in the servo loop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The handle moved faster than a hand does.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was computed was not a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device&apos;s readings came too late.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device is gone, or silent.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device&apos;s position jumped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The servo loop stood still.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move its handle to its stops: all the way out, then all the way in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put its stylus into the cradle. Or put its arm to rest and press its zero button, or hold down the button of its stylus.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See that it has power, and wait until it has started.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its motors are hot: let it rest for some minutes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It switched its force off: press its force button, or see its lamp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Armed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rising</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fault</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm the device to feel a force.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plug it in, then disconnect it here and connect it again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the handle rest, then arm the device again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No motors, no force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No force yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to touch yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force withheld</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force rising</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force shown, not felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fault: no force</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::GreyPreset</name>
    <message>
        <source>Bone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temporal bone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lung</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brain</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::HapticDevicePanel</name>
    <message>
        <source>here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to be tried</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not plugged in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not permitted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>library missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>service missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>needs firmware</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>needs homing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>needs calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not started</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>motors hot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>force switched off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not understood</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>key %1 only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>button %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>button %1 (second device: %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set up…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow the camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force only while held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow stiffness that may shake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Still connecting. Firmware takes a minute; what does not answer at all is given up with Cancel: unplug it, plug it in, and start Palpate again if that is not enough.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The motors may push from now on: hold the handle. Escape, Space in the 3-D view and the stop button take the force away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State of the force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Haptic devices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All known devices; those that are present come first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its maker&apos;s firmware file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Firmware file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file with which the maker of this device starts it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looks for the firmware file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device that turns the tool, where this one has no rotation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connects the chosen device, without a force, or disconnects it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looks for devices that were plugged in meanwhile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cables, permission, first use, and what can go wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right, up and towards you are the picture&apos;s; without it they stay as they are now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force only while this button, or %1 in the 3-D view, is held down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While this button, or %1 in the 3-D view, is held, the tool stays and the hand moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The button that is held for a force, beside %1 in the 3-D view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Millimetres of the tool for a millimetre of the hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up to what the device is rated for. Without it no stiffness can be set at which the device and a light hand may shake each other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device may shake, hard and at once: hold it firmly, and keep Escape in reach.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Newtons at the hand for a newton in the scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the hand to the scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clutch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Held by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <comment>a device and its place</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>held as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Firmware of the device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connecting %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 mm of the hand is %1 mm in the scan.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 N/m at the hand
%2 N/m in the scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No more is allowed to this device: %1 N/m at the hand were asked for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It moves the tool; nothing is felt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stiffness is lowered to %1 % for now: the hand and the device shook.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::HelpPage</name>
    <message>
        <source>Page of the help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arrow keys move through the page, Tab goes from link to link</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::HelpWindow</name>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The page before (Alt+Left)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The page after (Alt+Right)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words to look for in all pages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lists the pages that have all these words; Enter goes to the next place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contents of the help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pages of the help</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::HistogramSlider</name>
    <message>
        <source>air</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>soft tissue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag, or press the arrow keys; with Shift in small steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No scan yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::IsosurfacePanel</name>
    <message>
        <source>Isovalue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isovalue, typed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The intensity of the surface that is seen and felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A starting point, not a threshold for diagnosis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bone %1 HU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skin %1 HU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The isovalue must lie above the volume&apos;s least value, %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing in this volume is above %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::KeyButton</name>
    <message>
        <source>Press the key…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Change…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The next key is taken; Escape takes none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes another key for the chosen line: the next that is pressed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::Lasso</name>
    <message>
        <source>Drag: draws the outline that cuts. Or click, or %1 at the crosshair: sets a corner; at the last one again: cuts. %2: takes it back.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::LoadPlot</name>
    <message>
        <source>Tick time over number of points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>budget %1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 points: median %2, 99 % within %3, longest %4 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tick, ms: 99 %, and median to longest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>◆ present tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>● carried  × too many</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::MainWindow</name>
    <message>
        <source>%1 × %2 × %3 voxels · %4 × %5 × %6 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force stopped by Escape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing to touch yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force may come back: hold the handle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows in the help what lies behind this, and what helps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force stopped by Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Here, with File &gt; Open folder, or by dropping it on the window. Left and right come from the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag the line: what you see and touch is where the scan has this value. Picture and touch change at once.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press %1 and the mouse holds the tool, or drag the tool itself. The tool stops at the surface, and the card shows the force. Escape stops the force at any time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends what is loading or being worked out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not a medical device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Details</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Figures of the servo loop: rate, time of a tick, late ticks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (edited)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 — Palpate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force is off after a fault</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device is ready: no force until you arm it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force is off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Please confirm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save view…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not a medical device. Not for diagnosis. Force feedback hardware can move suddenly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before you begin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep hands and face clear of a device until it is at rest. Escape takes the force away at any time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was dropped is not on this machine&apos;s disks; copy it there first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens a scan in a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;folder…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a folder of slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From &amp;PACS…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;phantom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open recor&amp;ding…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings (*.palpate)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export recording…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;view…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Views (*.palpate-view)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save view &amp;as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Series of this folder…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;edited volume as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T&amp;heme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hi&amp;nts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout of the views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing of the &amp;surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ray casting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Controls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;First steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Palpate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;One view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Two by two</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;3-D large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Slices large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;First sizes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View &amp;alone, or all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Next view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pre&amp;ferences…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save edited volume as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NRRD (*.nrrd)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remember recent places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Forget recent places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;Force off&lt;/b&gt;: Escape anywhere, Space in the 3-D view, or the stop button.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Haptic device&lt;/b&gt; (View &gt; Haptic device): Connect, then Arm. While %1 is held in the 3-D view the tool stays and the hand moves freely; while %2 is held the force is on if it is to be held.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Mouse&lt;/b&gt;: it turns the picture until you take the tool (%3, or the button), and then moves the tool. The tool itself can be dragged at any time.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Measures&lt;/b&gt;: click where the places are, or drag a distance. Handles can be dragged in every view.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Slices&lt;/b&gt;: a right click, the key %4 or the button in the corner opens the choices: windows, slabs, contour, following the tool, the view down the tool.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Replay&lt;/b&gt;: on its bar, ▼ are marks, ◆ settings, ■ scene and camera, ● force and device, × samples lost and ticks late.&lt;/p&gt;&lt;p&gt;Keys can be changed: Edit &gt; Preferences, Shortcuts.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Controls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Palpate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;Palpate %1&lt;/b&gt;&lt;/p&gt;&lt;p&gt;See a CT scan, and feel it through a haptic device.&lt;/p&gt;&lt;p&gt;&lt;b&gt;%2&lt;/b&gt;&lt;/p&gt;&lt;p&gt;BSD-3-Clause licence. Palpate uses Qt (LGPL-3), VTK, vtk-dicom, Eigen, HDF5, DCMTK, CharLS, OpenJPEG, libarchive, libdeflate, hidapi and libusb (LGPL-2.1), libseccomp (LGPL-2.1), SQLite and others, as Debian packages them. The help lists all of them, with their licences.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::MarksPanel</name>
    <message>
        <source>&amp;Go to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;Not for treatment.&lt;/b&gt; ± is what the voxels allow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half a voxel diagonal for each place. Errors of the scanner and of the choice of the places are not in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press at the two ends, or drag from one to the other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press at the end of one leg, at the corner, and at the end of the other leg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press where the value is to be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press where the note belongs, then type it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (key %2 in a view)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures, marks and notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name or note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No measures or marks yet: choose one above, then click in a view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 goes to the place, %2 renames, %3 deletes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moves the crosshair to the place; again, to its next place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Renames the mark, or edits the note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deletes the mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brings back the mark that was deleted last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures the way of the tool from where it is now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends the measurement of the way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tool&apos;s way is not measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start at the tool</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::Measure</name>
    <message>
        <source>unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unknown: the legs are too short</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outside the scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::Measures</name>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Travelled %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not for treatment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click, or %1 at the crosshair: sets a place. %2: takes it back. Escape: ends.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::PacsServerDialog</name>
    <message>
        <source>Server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What you call the server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DICOMweb</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>DIMSE (C-FIND, C-GET)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the server is asked; DICOMweb where it has it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Protocol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The URL that ends before /studies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Host</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name or address of the server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server&apos;s port, often 104 or 11112</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;ort</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AE title of the &amp;server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As its administrator has named it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AE title of &amp;Palpate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The server must know this title and this computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;TLS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Encrypts the connection and checks the server&apos;s certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fetch by C-&amp;MOVE, at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For servers without C-GET. During a transfer, this computer then takes a connection from the server at this address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address and port for C-MOVE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address and port at which the server reaches this computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>user and password, asked each time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>token, asked each time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from the desktop&apos;s keyring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the server knows who asks; no password is stored by Palpate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Login</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;User</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The user&apos;s name at the server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Trusted certificates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Certificates (PEM) that are trusted beside the system&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own &amp;certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Certificate (PEM) of this computer, where the server asks for one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its private &amp;key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Private key (PEM) of that certificate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chooses a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::PacsWindow</name>
    <message>
        <source>From PACS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The archive that is asked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Describes another server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes what is known of the server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forgets the server</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Test</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asks the server whether it answers; a sentence says what is wrong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Password or token</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For the server; it is stored nowhere, and forgotten when the window closes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; * and ? stand for any letters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patient&apos;s number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The number of the patient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patient&apos;s name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FAMILY^GIVEN, as in the archive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Accession number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The number of the order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A day as 20240305, or a span as 20240301-20240331, either end left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Modality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which kind of scan is sought</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MR</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lists the series that match</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show patients&apos; &amp;names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lists patients and descriptions too; searches again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patient&apos;s n&amp;umber</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patient&apos;s na&amp;me</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;ccession number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Date</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>M&amp;odality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Series</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter or a double-click fetches a series</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Images</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Study&apos;s name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Series&apos; name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No series yet: choose a server, then search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fetch and open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fetches the chosen series into a folder that is emptied in the end, and opens it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends what the server is being asked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closes this window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the server of your archive first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 images, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 images, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Token</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Password of %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::PerformancePanel</name>
    <message>
        <source>Left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the measurement is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measure this machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ten seconds with the present volume, tool and stiffness: how long a tick takes, and how many points this machine carries</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends the measurement without a result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;%1&lt;/b&gt;: %2&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no misses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 miss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 misses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 points: longest tick %2 ms, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; not even %2 points, spread evenly, on this machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; %2 points and more on this machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; up to %2 points on this machine.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half of the ticks took at most %1 ms, 99 in 100 at most %2 ms of CPU.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None of %1 was cut by the budget of %2 ms.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 were cut by the budget of %3 ms, which kept the tool %4 mm farther from the hand in the mean.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less than 0.001</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>That is more than this machine carries.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meanwhile, by the clock on the wall, the live loop began %1 of %2 ticks late and missed %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suggested: the tool as it is. %1 points, spread evenly, would be no farther apart than the voxels (%2 mm).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suggested: %1 points, spread evenly. They are %2 mm apart, as the voxels are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Suggested: %1 points, spread evenly, %2 mm apart: the most that was carried. To be no farther apart than the voxels (%3 mm), the tool would need %4.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::PlacePick</name>
    <message>
        <source>Click a piece, or %1 at the crosshair: shows it. Escape: ends.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::PlaceTiles</name>
    <message>
        <source>Open %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens %1 again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no longer there</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::PreferencesWindow</name>
    <message>
        <source>Preferences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arrow keys go from page to page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset to &amp;defaults</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets all pages but the shortcuts as they are at first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closes the window; all is kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>General</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The colours of the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The unit of measures, positions, slabs and rulers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Say below each view what the mouse does there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows a line of hints at the foot of each view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Lengths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In measures and slices. Voxels, tools and the fields of edits stay in millimetres, forces in newtons.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At first the mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What a drag does in the 3-D view when the mouse becomes the hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>looks: a drag turns the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>holds the tool: a drag moves it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel over slices, turned away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which slice comes when the wheel is turned away from you</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>next slice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slice before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel for the size, turned away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the wheel does in 3-D, and with Ctrl over slices, when it is turned away from you</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>comes nearer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>goes away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;At first the mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel over &amp;slices, turned away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel for the si&amp;ze, turned away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All that the mouse does is in the list of shortcuts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin each time with the &amp;stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Else the stiffness is what it was when the window closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness at first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The spring between hand and tool; a haptic device brings its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> N/m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A haptic device begins with half of what it is rated for.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Choose a folder…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New recordings are written there, and listed from there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Own folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes Palpate&apos;s own folder among your files again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings are in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings that are there stay where they are. A recording that is running is finished where it began.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Privacy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remember recent places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps the eight newest folders and files for File &gt; Open recent; off forgets them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Forget them now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Removes the recent places from the preferences at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Palpate keeps no name, no date and no picture of a scan, and uses the network only where you open a scan from a PACS. Before a picture leaves it that may show a face, it asks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No place is remembered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One place is remembered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 places are remembered.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::RecordingLines</name>
    <message>
        <source>%1 N</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::RecordingPanel</name>
    <message>
        <source>room for %1 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>room for %1 h</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>a label and the name of the file</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unfinished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note: write no names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note of the mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is to be found again. Everyone who gets the recording can read it: do not write names of patients or staff.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets a mark at this moment, with the note (%1, or Enter in the note)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begins a recording of every tick, or ends it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No recordings yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter or a double-click opens a recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Label of the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Label: stays on this computer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your own words for this recording. They are kept on this computer only: neither the recording nor an export holds them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the chosen recording as tables or as a film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deletes the chosen recording, after a question</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finishing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped by itself: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 samples were lost: the recording is not whole.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marked at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>force not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>force up to %1 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replays the chosen recording in the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brings back what is in a recording that was never finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete it?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the recording %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It cannot be brought back.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::ReplayBar</name>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>−1 tick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+1 tick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One tick back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One tick forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play or pause (%1 while the bar has the focus)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the live session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How fast the recording plays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes to a mark that was set while this was recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marks (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::ReplayTimeline</name>
    <message>
        <source>Mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isovalue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angular stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clutch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gap: samples lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ticks that began late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ticks that were missed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▼ mark  ◆ setting  ■ scene, camera  ● force, device  × samples lost  | ticks late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time in the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click or a drag goes to another time; events say what they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>greatest force %1 N</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::Section</name>
    <message>
        <source>Unfold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, folded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, unfolded</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::SeriesBrowser</name>
    <message>
        <source>sound</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>correctable</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %2 × %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Series of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show patients&apos; &amp;names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows whose the series are, until the list is closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n series found</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Series</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter or a double-click loads a series</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is to be said of the selected series</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closes the list; what is on view stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle slice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Modality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Load series %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loads this series</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no picture</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::SetUpDialog</name>
    <message>
        <source>Set up: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::ShortcutList</name>
    <message>
        <source>left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search: a key, a place or what it does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the lines that have all these words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter or a double-click changes the key of a line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gives the chosen line the key that it has at first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gives every line the key that it has at first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At first: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press Change, then the key.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Escape and Space stop the force, and stay what they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the mouse does stays what it is.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::SidePanel</name>
    <message>
        <source>Scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is in the way, measures and marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface, hand and tool, performance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The haptic device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::SliceSet</name>
    <message>
        <source>S&amp;lices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Show all slices whole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Contour of the touched surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cross&amp;hair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Follow the tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View with the &amp;tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool view: &amp;along its axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool view: &amp;down its axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;picture of a slice…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves the slice as it is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Window and level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (W %2, L %3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Full range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Voxels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Interpolated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As they a&amp;re</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;One plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thick slab: &amp;maximum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thick slab: m&amp;ean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 thick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other &amp;thickness…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thick slab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Down the tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no tool yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>through its axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at its tip</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::SliceView</name>
    <message>
        <source>Axial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 slice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel: slices. Drag: crosshair. Right drag: brightness, contrast. Ctrl and wheel: nearer. Middle drag: shifts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>maximum of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>W %1  L %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left/right unknown</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::StartPage</name>
    <message>
        <source>Open your CT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A folder of DICOM slices, an archive, or an NRRD, MetaImage or NIfTI file. It can also be dropped on the window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open folder…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens a folder of slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens an archive or a volume in one file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try the demo skull</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A skull made by a formula, and a drill to touch it with. The mouse is the hand, so nothing else is needed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the demo skull with a drill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connect a haptic device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel the scan: a Falcon, Touch, Inverse3 and others. The list says what is found and what it needs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show devices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the list of haptic devices on the tab Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends loading and goes back to the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recent places are not remembered (File &gt; Open recent)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scans that you open will stand here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last scans</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::StateChip</name>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::StatusLine</name>
    <message>
        <source>ordinary priority</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>real-time priority</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 N · %2 contacts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>servo %1 Hz (%2), tick p99 %3 µs, late %4, missed %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hand: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ray casting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface: %1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::StopButton</name>
    <message>
        <source>Esc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>STOP FORCE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop force (Escape)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zero force at once (Escape anywhere, Space in the 3-D view)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::ToolList</name>
    <message>
        <source>length %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 · tip %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool from a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; the present tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No scan, no tool yet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::TopBar</name>
    <message>
        <source>State of the force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>REC %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::Tour</name>
    <message>
        <source>Skip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends the tour; Help shows it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes on to the next control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Done</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::UnitDialog</name>
    <message>
        <source>%1 m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 long,
%2 by %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit of the tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In which unit are the numbers of &quot;%1&quot;? The file does not say. Beside the box of the tool stands a hand of 18 cm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the tool</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::ViewActions</name>
    <message>
        <source>Save &amp;picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves a picture of the view or the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cop&amp;y picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies a picture of the 3-D view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a &amp;side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anterior (from the front)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Posterior (from behind)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Superior (from above)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inferior (from below)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the &amp;tool&apos;s side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Along the tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Parallel projection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;resets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A starting point, not a threshold for diagnosis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By tissue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ivory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Second s&amp;urface (seen, not felt)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The present isovalue, held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ta&amp;ke the tool with the mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mouse holds the tool (%1 in the 3-D view). The tool itself can be dragged at any time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool to cross&amp;hair</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crosshair to too&amp;l</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Co&amp;ntacts and force</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::ViewFrame</name>
    <message>
        <source>Choices for slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide the hints of all views (View &gt; Hints shows them again)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide hints</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the other views again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show this view alone</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::ViewGap</name>
    <message>
        <source>Border between views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag, or move with the arrow keys. %1 or a double-click: first sizes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::VolumeProp</name>
    <message>
        <source>OpenGL is older than 3.2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the volume is larger than the graphics can hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the volume is flat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as asked for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>software graphics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drawn by the graphics card</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::VolumeView</name>
    <message>
        <source>3-D view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: nothing is open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: surface at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag: moves the tool. Shift: turns it. Wheel: pushes it. Right drag: turns the picture. %1: lets go.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag: turns. Wheel: nearer. To touch: drag the tool, or take it with %1. Double-click: brings it there. Middle drag: shifts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag: turns. Wheel: nearer. Middle drag: shifts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left/right unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ui::bindings</name>
    <message>
        <source>Escape and Space stop the force, and stay what they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tab goes from one control to the next, and stays what it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt with a letter opens menus; choose another key.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What works while a key is held needs one key alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fields and lists need this key; choose one with Ctrl.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This key stays what it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is taken: %2, %3. Give that another key first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>double-click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift and %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl and %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>anywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>list of marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>histogram</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>border between views</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>replay bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3-D view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, on the tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, on the cube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, on a handle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, while measuring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, with the tool of an edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, looking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, mouse as hand</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
