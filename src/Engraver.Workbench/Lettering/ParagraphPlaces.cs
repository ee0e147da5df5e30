using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.TextMarkup;
using Engraver.Shaping;

namespace Engraver.Workbench.Lettering;

/// <summary>A second calculation of where the letters of an MTEXT are in the drawing, point by point from the groups of its record (DXF reference, "MTEXT"),
/// and of their number. The places of letters within the text are those of its layout.</summary>
internal sealed class ParagraphPlaces : ILetterPlaces
{
    private readonly Vector3D _at;
    private readonly Vector3D _along;
    private readonly Vector3D _up;
    private readonly Placement _inserts;
    private readonly double _reach;

    private ParagraphPlaces(PlacedText text, TextLayout layout)
    {
        (_at, _inserts) = (text.Written.Insertion, text.Inserts);
        (_along, _up) = DirectionsOf(text.Written);
        Letters = [.. layout.Glyphs.Select(LetterOf)];
        LineCurves = [.. layout.Rules.Select<LayoutRule, Func<double, Vector3D>>(rule => fraction => At(rule.From.X + (fraction * (rule.To.X - rule.From.X)), rule.From.Y + (fraction * (rule.To.Y - rule.From.Y))))];
        _reach = Letters.Select(letter => Math.Abs(letter.Pen) + Math.Abs(letter.Rise) + Math.Abs(letter.Scale * letter.Curves.Advance)).DefaultIfEmpty().Max();
        Size = Math.Max((At(_reach, 0.0) - Origin).Length, (At(0.0, _reach) - Origin).Length);
    }

    public IReadOnlyList<LetterPlaces.Letter> Letters { get; }

    public IEnumerable<Func<double, Vector3D>> LineCurves { get; }

    public Vector3D Origin => At(0.0, 0.0);

    public double Size { get; }

    public double LargestTerm => _inserts.Origin.Length + ((_inserts.XAxis.Length + _inserts.YAxis.Length + _inserts.ZAxis.Length) * (_at.Length + (2.0 * _reach)));

    public static ParagraphPlaces Of(PlacedText text, TextLayout layout) => new(text, layout);

    /// <summary>True if the layout has each character of the text; of letters that join, which have another number of shapes, at least one.</summary>
    public static bool HasEveryLetter(PlacedText text, TextLayout layout)
    {
        var (expected, joins) = (0, false);
        foreach (var part in MTextParser.Parse(text.Written.Raw).Paragraphs.SelectMany(paragraph => paragraph.Pieces).SelectMany(piece => piece.Stack is { } stack ? new[] { stack.Upper, stack.Lower } : [piece.Text]))
        {
            joins |= ComplexLine.IsComplex(part);
            expected += LetterRun.Composed(part).EnumerateRunes().Count(rune => !LetterRun.IsWithoutShape(rune) && !LetterRun.IsBlank(rune.Value));
        }

        return joins ? expected == 0 || layout.Glyphs.Count > 0 : layout.Glyphs.Count == expected;
    }

    public Vector3D At(LetterPlaces.Letter letter, double fontX, double fontY) =>
        At(letter.Pen + (letter.Scale * ((letter.Width * fontX) + (letter.Slope * fontY))), letter.Rise + (letter.Scale * fontY));

    /// <summary>A point of the plane of the text: along its lines, and above its insertion point.</summary>
    private Vector3D At(double along, double above)
    {
        var (u, v, w) = (_at.X + (_along.X * along) + (_up.X * above), _at.Y + (_along.Y * along) + (_up.Y * above), _at.Z + (_along.Z * along) + (_up.Z * above));
        return new Vector3D(
            _inserts.Origin.X + (_inserts.XAxis.X * u) + (_inserts.YAxis.X * v) + (_inserts.ZAxis.X * w),
            _inserts.Origin.Y + (_inserts.XAxis.Y * u) + (_inserts.YAxis.Y * v) + (_inserts.ZAxis.Y * w),
            _inserts.Origin.Z + (_inserts.XAxis.Z * u) + (_inserts.YAxis.Z * v) + (_inserts.ZAxis.Z * w));
    }

    /// <summary>Group 11 less its part in the direction of the extrusion, otherwise group 50 in the system of the extrusion.</summary>
    private static (Vector3D Along, Vector3D Up) DirectionsOf(WrittenText written)
    {
        var (x, y, z) = LetterPlaces.AxesOf(written.Extrusion);
        var (sin, cos) = Math.SinCos(Math.IEEERemainder(written.Rotation.Degrees, 360.0) * Math.PI / 180.0);
        var along = new Vector3D((x.X * cos) + (y.X * sin), (x.Y * cos) + (y.Y * sin), (x.Z * cos) + (y.Z * sin));
        if (written.Paragraphs?.XAxis is { } stated && stated != default)
        {
            var scale = 1.0 / Math.Max(Math.Abs(stated.X), Math.Max(Math.Abs(stated.Y), Math.Abs(stated.Z)));
            var (a, b, c) = (stated.X * scale, stated.Y * scale, stated.Z * scale);
            var over = ((a * z.X) + (b * z.Y) + (c * z.Z)) / ((z.X * z.X) + (z.Y * z.Y) + (z.Z * z.Z));
            var flat = new Vector3D(a - (over * z.X), b - (over * z.Y), c - (over * z.Z));
            var length = Math.Sqrt((flat.X * flat.X) + (flat.Y * flat.Y) + (flat.Z * flat.Z));
            if (length > 1e-9) along = new Vector3D(flat.X / length, flat.Y / length, flat.Z / length);
        }

        return (along, new Vector3D((z.Y * along.Z) - (z.Z * along.Y), (z.Z * along.X) - (z.X * along.Z), (z.X * along.Y) - (z.Y * along.X)));
    }

    private static LetterPlaces.Letter LetterOf(GlyphPlace glyph) =>
        new(glyph.Curves, glyph.Map.Origin.X, glyph.Map.YAxis.Y, glyph.Font.Font.IsOutline) { Rise = glyph.Map.Origin.Y, Width = glyph.Map.XAxis.X / glyph.Map.YAxis.Y, Slope = glyph.Map.YAxis.X / glyph.Map.YAxis.Y };
}
