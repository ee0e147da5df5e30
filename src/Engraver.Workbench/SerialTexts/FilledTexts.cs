using Engraver.Core.Drawings;

namespace Engraver.Workbench.SerialTexts;

/// <summary>A drawing with the fields in its texts filled.</summary>
public static class FilledTexts
{
    /// <summary>A text that does not change is the same object as before.</summary>
    public static Drawing Of(Drawing drawing, PlateValues values)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        ArgumentNullException.ThrowIfNull(values);
        return values.IsNone ? drawing : drawing with { Texts = [.. drawing.Texts.Select(text => Of(text, values))] };
    }

    private static PlacedText Of(PlacedText text, PlateValues values)
    {
        var raw = values.Fill(text.Written.Raw, text.Written.Tag);
        return raw == text.Written.Raw ? text : text with { Written = text.Written with { Raw = raw } };
    }
}
