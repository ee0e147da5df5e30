namespace Engraver.Core.TextMarkup;

/// <summary>Reads the properties of a paragraph: what is between \p and its semicolon.</summary>
internal static class ParagraphCodes
{
    /// <summary>The format with the stated properties changed; null when one of them is not known or has no valid value. A * returns a property to its
    /// default; the x that AutoCAD writes first has no effect.</summary>
    public static ParagraphFormat? Read(ReadOnlySpan<char> codes, ParagraphFormat before)
    {
        var format = before;
        for (var at = 0; at < codes.Length;)
        {
            var code = codes[at++];
            if (code is ',' or ' ' or 'x' or 'z') continue;
            if (code == 't') return Tabs(codes[at..]) is { } tabs ? format with { Tabs = tabs } : null;
            if (code == 'q')
            {
                if (at == codes.Length || AlignmentOf(codes[at++]) is not { } alignment) return null;
                format = format with { Alignment = alignment };
            }
            else if (code == 's')
            {
                if (at == codes.Length || SpacingOf(codes[at++]) is not { } spacing) return null;
                if (spacing == ParagraphSpacing.Default) format = format with { Spacing = spacing, SpacingValue = 0.0 };
                else if (TryNumber(codes, ref at, out var distance)) format = format with { Spacing = spacing, SpacingValue = distance };
                else return null;
            }
            else if (!TryNumber(codes, ref at, out var value) || Measure(format, code, value) is not { } changed)
            {
                return null;
            }
            else
            {
                format = changed;
            }
        }

        return format;
    }

    private static ParagraphFormat? Measure(ParagraphFormat format, char code, double value) => code switch
    {
        'i' => format with { Indent = value },
        'l' => format with { Left = value },
        'r' => format with { Right = value },
        'b' => format with { SpaceBefore = value },
        'a' => format with { SpaceAfter = value },
        _ => null,
    };

    /// <summary>Tab stops with commas between them: a number, or c (centre) or r (right) and a number. They are the last property; an empty list is the
    /// default.</summary>
    private static List<TabStop>? Tabs(ReadOnlySpan<char> codes)
    {
        var tabs = new List<TabStop>();
        for (var at = 0; at < codes.Length;)
        {
            if (codes[at] is ',' or ' ' or 'z' or '*')
            {
                at++;
                continue;
            }

            var alignment = codes[at] switch { 'c' => ParagraphAlignment.Centre, 'r' => ParagraphAlignment.Right, _ => ParagraphAlignment.Left };
            if (alignment != ParagraphAlignment.Left) at++;
            if (!TryNumber(codes, ref at, out var position)) return null;
            tabs.Add(new TabStop(position, alignment));
        }

        return tabs;
    }

    private static ParagraphAlignment? AlignmentOf(char letter) => letter switch
    {
        '*' => ParagraphAlignment.Default,
        'l' => ParagraphAlignment.Left,
        'r' => ParagraphAlignment.Right,
        'c' => ParagraphAlignment.Centre,
        'j' => ParagraphAlignment.Justified,
        'd' => ParagraphAlignment.Distributed,
        _ => null,
    };

    private static ParagraphSpacing? SpacingOf(char letter) => letter switch
    {
        '*' => ParagraphSpacing.Default,
        'e' => ParagraphSpacing.Exactly,
        'a' => ParagraphSpacing.AtLeast,
        'm' => ParagraphSpacing.Multiple,
        _ => null,
    };

    /// <summary>A number, or a * for 0.</summary>
    private static bool TryNumber(ReadOnlySpan<char> codes, ref int at, out double value)
    {
        value = 0.0;
        if (at < codes.Length && codes[at] == '*')
        {
            at++;
            return true;
        }

        var length = MTextNumber.LengthAt(codes[at..]);
        if (!MTextNumber.TryParse(codes.Slice(at, length), out value)) return false;
        at += length;
        return true;
    }
}
