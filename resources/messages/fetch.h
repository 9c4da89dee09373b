// SPDX-License-Identifier: BSD-3-Clause
// The sentences about a PACS, in the order of what a user does: options, connection, search,
// images.
#pragma once

#include "resources/messages/row.h"

namespace resources {

inline constexpr Row kFetch[] = {
    // options, and what comes on standard input
    {"fetch-host-and-port", "\"%1\" is no host and port; write it as pacs.example.org:104."},
    {"fetch-one-server", "Name one server: --dicomweb with a URL, or --dimse with host and port."},
    {"fetch-called-missing", "A server of DIMSE has an AE title; name it with --called."},
    {"fetch-login-of-web",
     "A login belongs to DICOMweb; DIMSE knows this program by its AE title, and by its "
     "certificate "
     "with --tls."},
    {"fetch-options-of-dimse",
     "--called, --tls and --move belong to DIMSE; a server of DICOMweb has a URL alone."},
    {"fetch-key-missing", "A certificate needs its private key: give --certificate and --key."},
    {"fetch-out-missing",
     "Name a new folder for the images with --out; without one, a parent program must hold "
     "standard "
     "input (--attached)."},
    {"fetch-url",
     "The URL of a server of DICOMweb is https:// or http:// with a host and a path, without user, "
     "password and query."},
    {"fetch-login-readable",
     "The login was not sent to \"%1\": without https everybody between could read it; use the "
     "server's https address."},
    {"fetch-login-missing",
     "Standard input has no login; give {\"login\": {\"user\", \"password\"}} or {\"login\": "
     "{\"token\"}}."},
    {"fetch-input-senseless",
     "Standard input is no JSON object; give one such as {\"query\": {\"patient_id\": …}}."},
    {"fetch-input-field",
     "Standard input has a field that is unknown or has a wrong value: \"%1\"; palpate-fetch's "
     "README lists them."},
    {"fetch-query-empty",
     "The query is empty, and a search for everything is not made; give a patient, an accession "
     "number, a date or a description."},
    {"fetch-index-missing", "Give the index of a series, as find lists them."},
    {"fetch-folder-not-empty",
     "\"%1\" is not an empty folder of yours; name a new one for the images."},
    {"fetch-listen-address",
     "\"%1\" is no numeric address; give the one at which the server reaches this machine."},
    {"fetch-move-needs-certificate",
     "C-MOVE with TLS needs a certificate of this machine, since the server connects to it; give "
     "--certificate and --key."},
    {"fetch-certificate-file", "\"%1\" is no certificate that can be read (PEM)."},
    {"fetch-key-file",
     "\"%1\" is no private key that can be read (PEM), or its passphrase is another."},
    {"fetch-no-keyring",
     "The desktop's keyring does not answer; unlock it, or log in with --login basic."},
    {"fetch-not-in-keyring",
     "The keyring has no entry for %1; store one, or log in with --login basic."},
    {"fetch-keyring-of-web",
     "The keyring has logins of DICOMweb; name its server with --dicomweb, and --user unless it is "
     "a token."},
    {"fetch-remembered", "The keyring has the login for %1 now."},
    {"fetch-forgotten", "The keyring has no login for %1 any more."},
    // the program itself
    {"fetch-cancelled", "Stopped; nothing of the transfer was kept."},
    {"fetch-not-started", "The transfer could not be started; close other programs and try again."},
    {"fetch-memory",
     "The server's answer needs more memory than a transfer may take; search more narrowly."},
    {"fetch-too-long", "The server was not done after %1 s, and the transfer was ended."},
    {"fetch-died",
     "The transfer ended by itself: what the server sent cannot be read, or needs more memory or "
     "time than allowed. Nothing was kept."},
    {"fetch-disk", "The images cannot be written to \"%1\"; look whether the disk is full."},
    // from the host to the permission
    {"fetch-host-unknown", "The host of \"%1\" is not known; check its name."},
    {"fetch-host-unreachable",
     "The host of \"%1\" does not answer; check its address, the network and the firewall."},
    {"fetch-port-closed",
     "The host of \"%1\" refuses the connection: no server listens at this port; check the port."},
    {"fetch-no-http",
     "What listens at \"%1\" does not answer as a web server does; check the port."},
    {"fetch-closed-at-once",
     "What listens at \"%1\" closed the connection without an answer; check the port, and whether "
     "the server wants TLS."},
    {"fetch-no-tls",
     "TLS could not be set up with \"%1\"; check the port, and whether the server has TLS there."},
    {"fetch-no-tls-here", "TLS could not be set up on this machine; install Palpate again."},
    {"fetch-certificate-expired",
     "The certificate of \"%1\" has expired or is not valid yet; check this machine's clock, and "
     "tell the server's administrator."},
    {"fetch-certificate-host",
     "The certificate of \"%1\" is for another host; check the host's name."},
    {"fetch-certificate-authority",
     "The certificate of \"%1\" is from an authority that this machine does not know; get the "
     "authority's certificate from the administrator and give it with --authority."},
    {"fetch-certificate-refused",
     "The certificate of \"%1\" is not valid; tell the server's administrator."},
    {"fetch-certificate-wanted",
     "\"%1\" wants a certificate of this machine; give --certificate and --key."},
    {"fetch-certificate-own-refused",
     "\"%1\" refuses this machine's certificate; ask the administrator for one that it trusts."},
    {"fetch-redirect",
     "\"%1\" sends this program to another host or in a circle, which is not followed; use the "
     "server's own URL."},
    {"fetch-login-wanted", "\"%1\" wants a login; give one with --login."},
    {"fetch-login-refused", "\"%1\" refuses the login; check user and password, or the token."},
    {"fetch-permission",
     "\"%1\" does not permit this; ask its administrator for permission to search and retrieve."},
    {"fetch-no-dicomweb",
     "There is no DICOMweb at \"%1\"; check the path of the URL, such as /dicom-web."},
    {"fetch-called-ae",
     "\"%1\" does not have the AE title \"%2\"; ask its administrator for the server's title."},
    {"fetch-calling-ae",
     "\"%1\" does not know this program's AE title \"%2\"; ask its administrator to add it, or "
     "give "
     "one that it knows with --calling."},
    {"fetch-rejected",
     "\"%1\" rejects the association from \"%3\" to \"%2\" without a reason; ask its administrator "
     "whether both AE titles are known to it."},
    {"fetch-busy", "\"%1\" takes no more associations for now; try again later."},
    {"fetch-no-echo",
     "\"%1\" does not permit \"%2\" an echo; ask its administrator for permission."},
    {"fetch-aborted",
     "\"%1\" ended the association at the first request: it does not know \"%2\" or does not "
     "permit it to search; ask its administrator."},
    {"fetch-no-find",
     "\"%1\" does not permit \"%2\" to search; ask its administrator for permission."},
    {"fetch-no-get",
     "\"%1\" offers no C-GET to this program; ask its administrator for permission, or switch "
     "C-MOVE "
     "on for it."},
    {"fetch-no-move",
     "\"%1\" offers no C-MOVE to this program; ask its administrator for permission."},
    {"fetch-move-destination",
     "\"%1\" does not know where to send images for \"%2\"; ask its administrator to enter this "
     "program's AE title with its address and port."},
    {"fetch-not-listening",
     "\"%1\" cannot be listened on: %2; give an address of this machine and a port that is free."},
    {"fetch-answers", "\"%1\" answers, and lets this program search."},
    // while it answers
    {"fetch-silent", "\"%1\" was silent for %2 s, and the transfer was ended; try again later."},
    {"fetch-slow",
     "\"%1\" sends less than %2 bytes a second, and the transfer was ended; try again later."},
    {"fetch-lost", "The connection to \"%1\" was lost; try again."},
    {"fetch-cut-off", "The server's answer was cut off; try again."},
    {"fetch-status", "\"%1\" answered with HTTP status %2; ask its administrator."},
    {"fetch-dimse-status",
     "\"%1\" answered with DIMSE status %2 (hexadecimal); ask its administrator."},
    {"fetch-dimse-senseless",
     "\"%1\" answered with a message that has no place there; ask its administrator."},
    {"fetch-dimse-too-long",
     "\"%1\" sent a message that is longer than any it was asked for; ask its administrator."},
    {"fetch-packed",
     "\"%1\" packed its answer although it was asked not to; ask its administrator."},
    {"fetch-multipart-senseless",
     "The server's answer is no multipart message as DICOMweb has them; ask its administrator."},
    {"fetch-json-senseless",
     "The server's answer is no list as DICOMweb has them; check the path of the URL."},
    {"fetch-answer-too-large", "The server's answer is too long; search more narrowly."},
    {"fetch-too-many-for-server", "\"%1\" finds too much; search more narrowly."},
    {"fetch-too-many-studies", "More than %1 studies match; search more narrowly."},
    {"fetch-too-many-series", "More than %1 series match; search more narrowly."},
    {"fetch-too-many-matches", "More than %1 entries match; search more narrowly."},
    {"fetch-entries-left-out",
     "%1 entries have no identifier as DICOM has them, and were left out."},
    {"fetch-no-such-series", "There is no series %1: %2 match."},
    {"fetch-list-changed",
     "The server's list has changed, and the index names another series now; search again."},
    // images
    {"fetch-no-images", "\"%1\" answered with something else than images; ask its administrator."},
    {"fetch-other-images",
     "\"%1\" sent images of another series than was asked for, and none of them was kept."},
    {"fetch-other-images-only",
     "The server sent more than %1 files that were not asked for, and the transfer was ended."},
    {"fetch-other-images-dropped",
     "%1 images of other series were sent although they were not asked for, and were not kept."},
    {"fetch-no-dicom", "\"%1\" sent files that are not DICOM, and none of them was kept."},
    {"fetch-files-dropped", "%1 files that are not DICOM were sent, and were not kept."},
    {"fetch-nothing-came",
     "\"%1\" sent no image of the series; ask its administrator for permission to retrieve."},
    {"fetch-images-missing", "%1 images that the server lists did not come."},
    {"fetch-too-many-images", "The series has more than %1 images, and none was kept."},
    {"fetch-too-many-bytes", "The series is larger than %1 GiB, and none of it was kept."},
};

}  // namespace resources
