using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Writing;

/// <summary>Writes texts so that they are read back with the same content, position and form: characters that the reader treats as codes are written as
/// codes.</summary>
internal static class DxfTextWriter
{
    private const int Backward = 2;

    /// <summary>Maximum length of one piece of an MTEXT in one pair.</summary>
    private const int PieceLength = 250;

    public static void Write(DxfTagWriter tags, in DxfSheetText entity)
    {
        var text = entity.Text;
        var isParagraph = text.Type == "MTEXT";
        tags.BeginEntity(isParagraph ? "MTEXT" : "TEXT", entity.Layer, DrawingColour.ByLayer, text.Hidden);
        if (isParagraph) Paragraph(tags, text);
        else Line(tags, text);
    }

    private static void Line(DxfTagWriter tags, PlacedText text)
    {
        var isBetween = text.End is not null;
        tags.Class("AcDbText").Point(10, text.Position).Real(40, text.Height).Text(1, Escaped(text.Content));
        tags.Real(50, text.Rotation.Degrees).Real(41, text.WidthFactor).Real(51, text.Oblique.Degrees).Text(7, text.Style);
        tags.Integer(71, text.Mirrored ? Backward : 0).Integer(72, (int)text.Column);
        if (isBetween || text.Column != TextColumnAlignment.Left || text.Row != TextRowAlignment.Baseline) tags.Point(11, text.End ?? text.Position);
        tags.Class("AcDbText").Integer(73, (int)text.Row);
    }

    /// <summary>A mirrored text has the extrusion 0,0,-1; its position and direction are nevertheless in world coordinates.</summary>
    private static void Paragraph(DxfTagWriter tags, PlacedText text)
    {
        tags.Class("AcDbMText").Point(10, text.Position).Real(40, text.Height).Real(41, text.FrameWidth);
        tags.Integer(71, 1 + (int)text.Column + (3 * (TextRowAlignment.Top - text.Row))).Integer(72, 1);
        var content = Escaped(text.Content).Replace(@"\", @"\\", StringComparison.Ordinal).Replace("{", @"\{", StringComparison.Ordinal).Replace("}", @"\}", StringComparison.Ordinal)
            .Replace("\n", @"\P", StringComparison.Ordinal).Replace("\u00A0", @"\~", StringComparison.Ordinal);
        if (text.WidthFactor != 1.0) content = FormattableString.Invariant($@"\W{text.WidthFactor:R};") + content;
        for (; content.Length > PieceLength; content = content[PieceLength..]) tags.Text(3, content[..PieceLength]);
        tags.Text(1, content).Text(7, text.Style);
        if (text.Mirrored) tags.Real(210, 0.0).Real(220, 0.0).Real(230, -1.0);
        tags.Point(11, new Vector3D(text.Rotation.Cos(), text.Rotation.Sin(), 0.0)).Integer(73, 1).Real(44, text.LineSpacing);
    }

    private static string Escaped(string content)
    {
        var text = content.Replace("^", "^ ", StringComparison.Ordinal).Replace("\t", "^I", StringComparison.Ordinal);
        return text.Contains("%%", StringComparison.Ordinal) ? text.Replace("%", "%%%", StringComparison.Ordinal) : text;
    }
}
