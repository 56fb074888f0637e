# SPDX-FileCopyrightText: the Transfer Function Combinations developers
# SPDX-License-Identifier: BSD-3-Clause
"""Server-manager XML: proxies and properties are documented, and their classes are in the tree.

The GUI's tooltips and help() in Python are made from this documentation.
"""
import os
import re
import xml.parsers.expat

import lint

PROXY = re.compile(r"^([A-Za-z]*Proxy|Extension)$")
PROPERTY = re.compile(r"^[A-Za-z]+Property$")
FEWEST_WORDS = 3


class Element:
    """An XML element that knows its line."""

    def __init__(self, tag, attributes, line):
        self.tag = tag
        self.attributes = attributes
        self.line = line
        self.children = []
        self.text = ""

    def get(self, name):
        return self.attributes.get(name, "")


def parse(text):
    """The root element of an XML text."""
    parser = xml.parsers.expat.ParserCreate()
    stack = [Element("", {}, 0)]

    def start(tag, attributes):
        element = Element(tag, attributes, parser.CurrentLineNumber)
        stack[-1].children.append(element)
        stack.append(element)

    def characters(data):
        stack[-1].text += data

    parser.StartElementHandler = start
    parser.EndElementHandler = lambda tag: stack.pop()
    parser.CharacterDataHandler = characters
    parser.Parse(text, True)
    return stack[0].children[0]


def check_documentation(element, what, short_help):
    """Findings about the <Documentation> of a proxy or property: (line, message)."""
    found = [child for child in element.children if child.tag == "Documentation"]
    if len(found) != 1:
        yield element.line, "%s needs one <Documentation>, it has %d" % (what, len(found))
        return
    if len(found[0].text.split()) < FEWEST_WORDS:
        yield found[0].line, "%s: the <Documentation> says nothing" % what
    if short_help and len(found[0].get("short_help").split()) < FEWEST_WORDS:
        yield found[0].line, "%s: the <Documentation> needs a short_help" % what


def check_class(element, what, headers):
    """Findings about the class of a proxy: (line, message)."""
    name = element.get("class")
    if name and name + ".h" not in headers:
        yield element.line, "%s: there is no %s.h in the tree" % (what, name)


def check_proxy(proxy, headers):
    """Findings about a proxy or an extension of one, its properties and what is inside them."""
    what = "%s %s" % (proxy.tag, proxy.get("name"))
    extension = proxy.tag == "Extension"
    yield from check_documentation(proxy, what, short_help=not extension)
    yield from check_class(proxy, what, headers)
    pending = list(proxy.children)
    while pending:
        element = pending.pop(0)
        if PROPERTY.match(element.tag) and element.tag != "Property":
            name = "%s: property %s" % (what, element.get("name"))
            yield from check_documentation(element, name, short_help=False)
        pending += element.children


paths = [path for path in lint.files(".xml")
         if b"<ServerManagerConfiguration>" in lint.content(path)]
headers = {os.path.basename(path) for path in lint.files(".h")}
problems = []
for path in paths:
    try:
        root = parse(lint.content(path))
    except xml.parsers.expat.ExpatError as error:
        problems.append("%s:%d: %s" % (path, error.lineno, error))
        continue
    for group in root.children:
        for proxy in group.children:
            if PROXY.match(proxy.tag):
                problems += ["%s:%d: %s" % (path, line, message)
                             for line, message in check_proxy(proxy, headers)]
lint.finish(problems, len(paths))
