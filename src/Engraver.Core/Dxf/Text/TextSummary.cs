using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.TextMarkup;

namespace Engraver.Core.Dxf.Text;

/// <summary>Derives the summary of a text (position, height, direction, readable content) from what its record states.</summary>
public static class TextSummary
{
    /// <summary>The text with the values that follow from <see cref="PlacedText.Written"/> and <see cref="PlacedText.Inserts"/>.</summary>
    public static PlacedText Derived(PlacedText text)
    {
        ArgumentNullException.ThrowIfNull(text);
        var own = text.Written.Paragraphs is { } paragraphs ? OfParagraphs(text, text.Written, paragraphs) : OfLine(text, text.Written);
        return text.Inserts.IsIdentity ? own : PlacedTexts.Placed(own, text.Inserts);
    }

    /// <summary>Where the text is out of the range of a drawing.</summary>
    public static bool IsInRange(PlacedText text)
    {
        ArgumentNullException.ThrowIfNull(text);
        return PlacedTexts.IsInRange(text);
    }

    private static PlacedText OfParagraphs(PlacedText text, WrittenText written, WrittenParagraphs paragraphs)
    {
        var attachment = Math.Clamp(paragraphs.Attachment, 1, 9) - 1;
        return text with
        {
            Content = TextContent.OfMText(CharacterEscapes.Resolved(written.Raw)),
            Position = written.Insertion,
            End = null,
            Height = written.Height,
            WidthFactor = 1.0,
            Oblique = default,
            Rotation = DirectionOf(written, paragraphs),
            Mirrored = written.Extrusion.Z < 0.0,
            FrameWidth = paragraphs.ReferenceWidth,
            LineSpacing = paragraphs.LineSpacingFactor,
            Column = (TextColumnAlignment)(attachment % 3),
            Row = (TextRowAlignment)(TextRowAlignment.Top - (attachment / 3)),
        };
    }

    /// <summary>Direction of the lines: a vector, or an angle, which is measured in the entity's own system.</summary>
    private static Angle DirectionOf(WrittenText written, WrittenParagraphs paragraphs)
    {
        if (paragraphs.XAxis is { } vector) return Angle.Direction(vector.X, vector.Y);
        return written.Extrusion.Z < 0.0 ? Angle.FromDegrees(180.0) - written.Rotation : written.Rotation;
    }

    private static PlacedText OfLine(PlacedText text, WrittenText written)
    {
        var column = (TextColumnAlignment)Math.Clamp(written.Horizontal, 0, 5);
        var row = (TextRowAlignment)Math.Clamp(written.Vertical, 0, 3);
        var between = column is TextColumnAlignment.Aligned or TextColumnAlignment.Fit;
        var second = column != TextColumnAlignment.Left || row != TextRowAlignment.Baseline ? written.Second : null;
        var own = text with
        {
            Content = TextContent.OfText(CharacterEscapes.Resolved(written.Raw)),
            Position = second is { } reference && !between ? reference : written.Insertion,
            End = between ? second : null,
            Height = written.Height,
            WidthFactor = written.WidthFactor,
            Oblique = written.Oblique,
            Rotation = written.Rotation,
            Mirrored = written.Generation.HasFlag(TextGeneration.Backwards),
            FrameWidth = 0.0,
            LineSpacing = 1.0,
            Column = column,
            Row = row,
        };
        return written.OwnSystem is { IsIdentity: false } system ? PlacedTexts.Placed(own, system) : own;
    }
}
