using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.Core.Dxf.Writing;

/// <summary>Writes texts so that they are read back with the same content, position and form: as they were read where they have not been moved since, otherwise
/// with the values that their place gives them. The string is written as read, unless the text was scaled and its codes have heights.</summary>
internal static class DxfTextWriter
{
    /// <summary>Relative difference of heights up to which a text was not scaled.</summary>
    private const double UnscaledTolerance = 1e-9;

    /// <summary>Maximum length of one piece of an MTEXT in one pair.</summary>
    private const int PieceLength = 250;

    public static void Write(DxfTagWriter tags, in DxfSheetText entity)
    {
        var text = entity.Text;
        var isParagraph = text.Type == "MTEXT";
        tags.BeginEntity(isParagraph ? "MTEXT" : "TEXT", entity.Layer, text.Colour, text.Hidden, lineweight: text.Lineweight == Lineweight.ByLayer ? null : text.Lineweight);
        if (text.Inserts.IsIdentity && isParagraph) WrittenParagraph(tags, text);
        else if (text.Inserts.IsIdentity) WrittenLine(tags, text);
        else if (isParagraph) Paragraph(tags, text);
        else Line(tags, text);
    }

    private static void WrittenLine(DxfTagWriter tags, PlacedText text)
    {
        var written = text.Written;
        tags.Class("AcDbText").Point(10, written.Insertion).Real(40, written.Height).Text(1, OneLine(written.Raw));
        tags.Real(50, written.Rotation.Degrees).Real(41, written.WidthFactor).Real(51, written.Oblique.Degrees).Text(7, text.Style);
        tags.Integer(71, (int)written.Generation).Integer(72, written.Horizontal);
        if (written.Second is { } second) tags.Point(11, second);
        Extrusion(tags, written);
        tags.Class("AcDbText").Integer(73, written.Vertical);
    }

    private static void WrittenParagraph(DxfTagWriter tags, PlacedText text)
    {
        var (written, paragraphs) = (text.Written, text.Written.Paragraphs!);
        tags.Class("AcDbMText").Point(10, written.Insertion).Real(40, written.Height).Real(41, paragraphs.ReferenceWidth);
        tags.Integer(71, paragraphs.Attachment).Integer(72, paragraphs.FlowDirection);
        Pieces(tags, OneLine(written.Raw));
        tags.Text(7, text.Style);
        Extrusion(tags, written);
        if (paragraphs.XAxis is { } axis) tags.Point(11, axis);
        else tags.Real(50, written.Rotation.Degrees);
        tags.Integer(73, paragraphs.LineSpacingStyle).Real(44, paragraphs.LineSpacingFactor);
        if (paragraphs.Columns is { } columns) Columns(tags, columns, paragraphs.DefinedHeight);
    }

    private static void Extrusion(DxfTagWriter tags, WrittenText written)
    {
        if (written.Extrusion != new Vector3D(0.0, 0.0, 1.0)) tags.Real(210, written.Extrusion.X).Real(220, written.Extrusion.Y).Real(230, written.Extrusion.Z);
    }

    /// <summary>The columns as releases before 2018 write them, except for links: the linked records are written as texts.</summary>
    private static void Columns(DxfTagWriter tags, TextColumns columns, double definedHeight)
    {
        tags.Text(1001, "ACAD").Text(1000, "ACAD_MTEXT_COLUMN_INFO_BEGIN");
        foreach (var (code, value) in new[] { (75, columns.Type), (79, columns.IsAutoHeight ? 1 : 0), (76, columns.Count), (78, columns.IsFlowReversed ? 1 : 0) }) tags.Integer(1070, code).Integer(1070, value);
        tags.Integer(1070, 48).Real(1040, columns.Width).Integer(1070, 49).Real(1040, columns.Gutter);
        if (columns.Heights.Count > 0) tags.Integer(1070, 50).Integer(1070, columns.Heights.Count);
        foreach (var height in columns.Heights) tags.Real(1040, height);
        tags.Text(1000, "ACAD_MTEXT_COLUMN_INFO_END");
        tags.Text(1000, "ACAD_MTEXT_DEFINED_HEIGHT_BEGIN").Integer(1070, 46).Real(1040, definedHeight).Text(1000, "ACAD_MTEXT_DEFINED_HEIGHT_END");
    }

    /// <summary>A string of a binary file may have line ends; in a text file they are control characters with a caret.</summary>
    private static string OneLine(string raw) => raw.Replace("\r", "^M", StringComparison.Ordinal).Replace("\n", "^J", StringComparison.Ordinal);

    private static void Pieces(DxfTagWriter tags, string content)
    {
        for (; content.Length > PieceLength; content = content[PieceLength..]) tags.Text(3, content[..PieceLength]);
        tags.Text(1, content);
    }

    /// <summary>True for a moved text whose string has the same meaning at its place: heights in it (\H2.5;) do not change with the scale.</summary>
    private static bool KeepsString(PlacedText text) =>
        !text.Written.Raw.Contains(@"\H", StringComparison.Ordinal) || Math.Abs(text.Height - text.Written.Height) <= text.Height * UnscaledTolerance;

    private static void Line(DxfTagWriter tags, PlacedText text)
    {
        var isBetween = text.End is not null;
        tags.Class("AcDbText").Point(10, text.Position).Real(40, text.Height).Text(1, OneLine(text.Written.Raw));
        tags.Real(50, text.Rotation.Degrees).Real(41, text.WidthFactor).Real(51, text.Oblique.Degrees).Text(7, text.Style);
        tags.Integer(71, (int)GenerationOf(text)).Integer(72, (int)text.Column);
        if (isBetween || text.Column != TextColumnAlignment.Left || text.Row != TextRowAlignment.Baseline) tags.Point(11, text.End ?? text.Position);
        tags.Class("AcDbText").Integer(73, (int)text.Row);
    }

    /// <summary>A place that mirrors the text mirrors its letters across their line.</summary>
    private static TextGeneration GenerationOf(PlacedText text) =>
        text.Mirrored == text.Written.Generation.HasFlag(TextGeneration.Backwards) ? text.Written.Generation : text.Written.Generation ^ TextGeneration.UpsideDown;

    /// <summary>A mirrored text has the extrusion 0,0,-1; its position and direction are nevertheless in world coordinates.</summary>
    private static void Paragraph(DxfTagWriter tags, PlacedText text)
    {
        tags.Class("AcDbMText").Point(10, text.Position).Real(40, text.Height).Real(41, text.FrameWidth);
        tags.Integer(71, 1 + (int)text.Column + (3 * (TextRowAlignment.Top - text.Row))).Integer(72, 1);
        var content = KeepsString(text) ? OneLine(text.Written.Raw) : Unformatted(text.Content);
        if (text.WidthFactor != 1.0) content = FormattableString.Invariant($@"\W{text.WidthFactor:R};") + content;
        Pieces(tags, content);
        tags.Text(7, text.Style);
        if (text.Mirrored) tags.Real(210, 0.0).Real(220, 0.0).Real(230, -1.0);
        tags.Point(11, new Vector3D(text.Rotation.Cos(), text.Rotation.Sin(), 0.0)).Integer(73, 1).Real(44, text.LineSpacing);
    }

    private static string Unformatted(string content) => Escaped(content).Replace(@"\", @"\\", StringComparison.Ordinal).Replace("{", @"\{", StringComparison.Ordinal).Replace("}", @"\}", StringComparison.Ordinal)
        .Replace("\n", @"\P", StringComparison.Ordinal).Replace("\u00A0", @"\~", StringComparison.Ordinal);

    private static string Escaped(string content)
    {
        var text = content.Replace("^", "^ ", StringComparison.Ordinal).Replace("\t", "^I", StringComparison.Ordinal);
        return text.Contains("%%", StringComparison.Ordinal) ? text.Replace("%", "%%%", StringComparison.Ordinal) : text;
    }
}
