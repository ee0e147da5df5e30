namespace Engraver.Fonts.OpenType.Outlines;

/// <summary>Operators of Type 2 charstrings by their number; 1200 is added to the second byte of those that have two.</summary>
internal enum CharstringOperator
{
    HStem = 1,
    VStem = 3,
    VMoveTo = 4,
    RLineTo = 5,
    HLineTo = 6,
    VLineTo = 7,
    RRCurveTo = 8,
    CallSubroutine = 10,
    Return = 11,
    EndChar = 14,
    HStemHm = 18,
    HintMask = 19,
    CounterMask = 20,
    RMoveTo = 21,
    HMoveTo = 22,
    VStemHm = 23,
    RCurveLine = 24,
    RLineCurve = 25,
    VVCurveTo = 26,
    HHCurveTo = 27,
    Short = 28,
    CallGlobalSubroutine = 29,
    VHCurveTo = 30,
    HVCurveTo = 31,
    HFlex = 1234,
    Flex = 1235,
    HFlex1 = 1236,
    Flex1 = 1237,
}
