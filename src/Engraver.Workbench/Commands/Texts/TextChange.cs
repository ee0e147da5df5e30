using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Text;
using Engraver.Core.Geometry;
using Engraver.Workbench.LetteredDrawings;

namespace Engraver.Workbench.Commands.Texts;

/// <summary>Changes of single values of a text; its place in blocks and earlier edits are kept.</summary>
internal static class TextChange
{
    /// <summary>The drawing with one text replaced.</summary>
    public static Drawing Replaced(Drawing drawing, int text, PlacedText by) => Replaced(drawing, new Dictionary<int, PlacedText> { [text] = by });

    /// <summary>The drawing with some texts replaced.</summary>
    public static Drawing Replaced(Drawing drawing, IReadOnlyDictionary<int, PlacedText> texts) =>
        drawing with { Texts = [.. drawing.Texts.Select((old, index) => texts.GetValueOrDefault(index) ?? old)] };

    /// <summary>With another height of the letters in the drawing.</summary>
    public static PlacedText WithHeight(PlacedText text, double height)
    {
        var factor = text.Height > 0.0 ? text.Written.Height / text.Height : 1.0;
        return Changed(text, text.Written with { Height = height * factor });
    }

    /// <summary>With another direction in the drawing.</summary>
    public static PlacedText WithRotation(PlacedText text, Angle rotation)
    {
        var turn = IsReversed(text) ? text.Rotation - rotation : rotation - text.Rotation;
        var written = text.Written;
        if (written.Paragraphs is not { } paragraphs) return Changed(text, written with { Rotation = (written.Rotation + turn).Positive() });
        var direction = (TextSummary.Derived(text with { Inserts = Placement.Identity }).Rotation + turn).Positive();
        return Changed(text, written with { Paragraphs = paragraphs with { XAxis = new Vector3D(direction.Cos(), direction.Sin(), 0.0) } });
    }

    public static PlacedText WithWidthFactor(PlacedText text, double factor) => Changed(text, text.Written with { WidthFactor = text.WidthFactor != 0.0 ? text.Written.WidthFactor * factor / text.WidthFactor : factor });

    public static PlacedText WithOblique(PlacedText text, Angle oblique) => Changed(text, text.Written with { Oblique = oblique });

    public static PlacedText WithStyle(PlacedText text, TextStyle style) => TextSummary.Derived(text with { Style = style.Name, Font = style.FontFile });

    /// <summary>With another justification. The reference point stays where it is, so that the letters move, except for Align and Fit, which keep the
    /// line.</summary>
    public static PlacedText WithJustification(Drawing drawing, PlacedText text, TextJustification to)
    {
        var written = text.Written;
        if (written.Paragraphs is { } paragraphs) return Changed(text, written with { Paragraphs = paragraphs with { Attachment = to.Attachment } });
        if (to.IsBetween) return Changed(text, written with { Horizontal = to.Horizontal, Vertical = to.Vertical, Insertion = StartOf(drawing, text, 0.0), Second = StartOf(drawing, text, 1.0) });
        var reference = TextJustification.Of(text) is { IsLeft: false, IsBetween: false } ? written.Second ?? written.Insertion : written.Insertion;
        return Changed(text, written with { Horizontal = to.Horizontal, Vertical = to.Vertical, Insertion = reference, Second = to.IsLeft ? null : reference });
    }

    /// <summary>A point of the base line in the own system of the text, from its start (0) to its end (1).</summary>
    private static Vector3D StartOf(Drawing drawing, PlacedText text, double part)
    {
        var written = text.Written;
        if (TextJustification.Of(text).IsBetween && written.Second is { } second) return part == 0.0 ? written.Insertion : second;
        var plain = TextSummary.Derived(text with { Inserts = Placement.Identity, Written = written with { Horizontal = 0, Vertical = 0, Rotation = default, Insertion = default, Second = null, Extrusion = default } });
        var letters = ShownDrawing.LettersOf(drawing, [plain]);
        var width = DrawingPick.BoundsOf(letters, [0]) is { IsEmpty: false } box ? Math.Max(box.MaxX, written.Height) : written.Height;
        return written.Insertion + (new Vector3D(written.Rotation.Cos(), written.Rotation.Sin(), 0.0) * (width * part));
    }

    private static PlacedText Changed(PlacedText text, WrittenText written) => TextSummary.Derived(text with { Written = written });

    /// <summary>True if the place of the text reverses the sense of its angles.</summary>
    private static bool IsReversed(PlacedText text)
    {
        var place = text.Inserts.After(text.Written.OwnSystem);
        var (x, y) = (place.ApplyToDirection(new Vector3D(1.0, 0.0, 0.0)), place.ApplyToDirection(new Vector3D(0.0, 1.0, 0.0)));
        return (x.X * y.Y) - (x.Y * y.X) < 0.0;
    }
}
