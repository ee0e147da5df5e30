using System.Globalization;
using Engraver.Core.Drawings;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>Text form of colours: AutoCAD's names for the first seven, numbers for the rest, red,green,blue for true colours.</summary>
public static class ColourName
{
    private const int StandardColours = 7;

    /// <summary>English names are accepted in every language.</summary>
    private static readonly string[] s_names = ["red", "yellow", "green", "cyan", "blue", "magenta", "white"];

    /// <summary>Names of the colours 1 to 7, in the current language.</summary>
    public static IReadOnlyList<string> Known => Wording.Get("ColourName.All").Split(',', StringSplitOptions.TrimEntries) is { Length: StandardColours } names ? names : s_names;

    /// <summary>Null if the text is not a valid layer colour.</summary>
    public static DrawingColour? Parse(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        var word = typed.Trim();
        var spoken = Known;
        for (var named = 0; named < StandardColours; named++)
        {
            if (word.Equals(s_names[named], StringComparison.OrdinalIgnoreCase) || WithoutSharpS(word).Equals(WithoutSharpS(spoken[named]), StringComparison.OrdinalIgnoreCase)) return DrawingColour.FromCode62(named + 1);
        }

        byte[] channels = [.. word.Split(',').Select(Channel).TakeWhile(channel => channel is not null).Select(channel => channel!.Value)];
        if (channels.Length != word.Count(letter => letter == ',') + 1) return null;
        return channels switch
        {
            [> 0 and var index] => DrawingColour.FromCode62(index),
            [var red, var green, var blue] => DrawingColour.FromCode420((red << 16) | (green << 8) | blue),
            _ => null,
        };
    }

    /// <summary>Keyboards without ß write ss.</summary>
    private static string WithoutSharpS(string word) => word.Replace("ß", "ss", StringComparison.Ordinal);

    /// <summary>The colour in typed form, in the current language.</summary>
    public static string Format(DrawingColour colour) => Format(colour, Known);

    /// <summary>The colour in the typed form that is valid in every language.</summary>
    public static string FormatInEnglish(DrawingColour colour) => Format(colour, s_names);

    private static string Format(DrawingColour colour, IReadOnlyList<string> names)
    {
        if (colour.Rgb is { } rgb) return FormattableString.Invariant($"{(rgb >> 16) & 0xFF},{(rgb >> 8) & 0xFF},{rgb & 0xFF}");
        var index = colour.OrForeground().Index!.Value;
        return index <= StandardColours ? names[index - 1] : index.ToString(CultureInfo.InvariantCulture);
    }

    /// <summary>Like <see cref="Parse"/>, but also accepts "bylayer" and "byblock", which only objects may have.</summary>
    public static DrawingColour? ParseOfObject(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        return typed.Trim().ToUpperInvariant() switch { "BYLAYER" => DrawingColour.ByLayer, "BYBLOCK" => DrawingColour.ByBlock, _ => Parse(typed) };
    }

    /// <summary>The colour of an object in typed form.</summary>
    public static string OfObject(DrawingColour colour) => colour.IsByLayer ? "ByLayer" : colour.IsByBlock ? "ByBlock" : Format(colour);

    private static byte? Channel(string text) => byte.TryParse(text.Trim(), NumberStyles.None, CultureInfo.InvariantCulture, out var value) ? value : null;
}
