using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.TextMarkup;
using Engraver.Fonts;
using Engraver.Fonts.Finding;

namespace Engraver.Workbench.Lettering;

/// <summary>A second calculation of the places of the letters of a TEXT or an attribute, point by point with sines and cosines from the groups of its record
/// (DXF reference, "TEXT"). It shares the choice of shapes with the layout that is cut, and for letters that join the
/// shaper; no formula of placing.</summary>
internal sealed class LetterPlaces : ILetterPlaces
{
    private readonly WrittenText _written;
    private readonly Placement _inserts;
    private readonly double _width;
    private readonly double _slope;
    private readonly double _turn;
    private readonly (double X, double Y) _anchor;
    private readonly Vector3D _at;
    private readonly (Vector3D X, Vector3D Y, Vector3D Z) _axes;

    private LetterPlaces(PlacedText text, FoundFont font, double height)
    {
        (_written, _inserts) = (text.Written, text.Inserts);
        var between = _written is { Horizontal: 3 or 5, Second: { } end } ? end - _written.Insertion : (Vector3D?)null;
        (Letters, Lines, var natural) = LineOf(font, height);
        var stretch = between is { } way ? Math.Sqrt((way.X * way.X) + (way.Y * way.Y) + (way.Z * way.Z)) / natural : 1.0;
        Advance = natural * stretch;
        Height = _written.Horizontal == 3 && between is not null ? height * stretch : height;
        Letters = [.. Letters.Select(letter => letter with { Pen = letter.Pen * stretch, Rise = letter.Rise * Height / height, Scale = letter.Scale * Height / height })];
        Lines = [.. Lines.Select(line => (line.From * stretch, line.To * stretch, line.Above * Height / height))];
        _width = Math.Abs(_written.WidthFactor) * (Height == height ? stretch : 1.0);
        _slope = Math.Tan(Math.Clamp(Math.IEEERemainder(_written.Oblique.Degrees, 360.0), -85.0, 85.0) * Math.PI / 180.0);
        _turn = between is { } along ? Math.Atan2(along.Y, along.X) : Math.IEEERemainder(_written.Rotation.Degrees, 360.0) * Math.PI / 180.0;
        _at = between is null && _written.Second is { } second && (_written.Horizontal, _written.Vertical) != (0, 0) ? second : _written.Insertion;
        _anchor = between is null ? AnchorOf(font.Font.Metrics) : default;
        _axes = AxesOf(_written.Extrusion);
    }

    /// <summary>The characters that have a shape.</summary>
    public IReadOnlyList<Letter> Letters { get; }

    /// <summary>Lines drawn with the letters, in the line: from, to, height above the baseline.</summary>
    public IReadOnlyList<(double From, double To, double Above)> Lines { get; }

    /// <summary>Length of the line, drawing units before the inserts.</summary>
    public double Advance { get; }

    /// <summary>Height of capital letters, drawing units before the inserts.</summary>
    public double Height { get; }

    public IEnumerable<Func<double, Vector3D>> LineCurves => Lines.Select<(double From, double To, double Above), Func<double, Vector3D>>(line => fraction => OnLine(line.From + (fraction * (line.To - line.From)), line.Above));

    public Vector3D Origin => OnLine(0.0, 0.0);

    public double Size => Math.Max((OnLine(Advance, 0.0) - Origin).Length, (OnLine(0.0, Height) - Origin).Length);

    /// <summary>Largest number that the calculation adds: its rounding is in every coordinate.</summary>
    public double LargestTerm => _inserts.Origin.Length + ((_inserts.XAxis.Length + _inserts.YAxis.Length + _inserts.ZAxis.Length) * (_at.Length + Advance + Height));

    /// <summary>Of a text that has a size.</summary>
    public static LetterPlaces Of(PlacedText text, TextStyle style, FoundFont font) => new(text, font, text.Written.Height > 0.0 ? text.Written.Height : style.FixedHeight);

    /// <summary>A point of a letter in the drawing.</summary>
    public Vector3D At(Letter letter, double fontX, double fontY)
    {
        var above = letter.Rise + (letter.Scale * fontY);
        return At(letter.Pen + (letter.Scale * _width * fontX) + (_slope * above), above);
    }

    /// <summary>A point of a line drawn with the letters.</summary>
    public Vector3D OnLine(double along, double above) => At(along + (_slope * above), above);

    /// <summary>A point of the line of letters: from the start of the baseline, before mirroring.</summary>
    private Vector3D At(double along, double above)
    {
        var (a, b) = (along - _anchor.X, above - _anchor.Y);
        if (_written.Generation.HasFlag(TextGeneration.Backwards) != _written.WidthFactor < 0.0) a = -a;
        if (_written.Generation.HasFlag(TextGeneration.UpsideDown)) b = -b;
        var (sin, cos) = Math.SinCos(_turn);
        var (x, y, z) = (_at.X + (a * cos) - (b * sin), _at.Y + (a * sin) + (b * cos), _at.Z);
        var (u, v, w) = (
            (_axes.X.X * x) + (_axes.Y.X * y) + (_axes.Z.X * z),
            (_axes.X.Y * x) + (_axes.Y.Y * y) + (_axes.Z.Y * z),
            (_axes.X.Z * x) + (_axes.Y.Z * y) + (_axes.Z.Z * z));
        return new Vector3D(
            _inserts.Origin.X + (_inserts.XAxis.X * u) + (_inserts.YAxis.X * v) + (_inserts.ZAxis.X * w),
            _inserts.Origin.Y + (_inserts.XAxis.Y * u) + (_inserts.YAxis.Y * v) + (_inserts.ZAxis.Y * w),
            _inserts.Origin.Z + (_inserts.XAxis.Z * u) + (_inserts.YAxis.Z * v) + (_inserts.ZAxis.Z * w));
    }

    private (IReadOnlyList<Letter> Letters, IReadOnlyList<(double From, double To, double Above)> Lines, double Natural) LineOf(FoundFont font, double height)
    {
        var (letters, lines, pen, width, notes) = (new List<Letter>(), new List<(double, double, double)>(), 0.0, Math.Abs(_written.WidthFactor), new LayoutNotes());
        foreach (var run in TextCodes.Parse(_written.Raw).Runs)
        {
            var (from, earlier) = (pen, default(int?));
            var joined = LetterRun.ShapedOf(run.Text, font, LetterFormat.Upright(height), default, notes);
            if (joined is not null)
            {
                letters.AddRange(joined.Glyphs.Select(glyph => new Letter(glyph.Curves, from + (width * glyph.Map.Origin.X), glyph.Map.YAxis.Y, glyph.Font.Font.IsOutline) { Rise = glyph.Map.Origin.Y }));
                pen += width * joined.Advance;
            }

            foreach (var (source, character, curves) in joined is null ? LetterRun.ShapesOf(run.Text, font, notes) : [])
            {
                var scale = height / source.Font.Metrics.CapHeight;
                var isOwn = ReferenceEquals(source, font);
                if (isOwn && earlier is { } left) pen += width * scale * LetterRun.KerningOf(font.Font, left, character);
                if (curves.Contours.Count > 0) letters.Add(new Letter(curves, pen, scale, source.Font.IsOutline));
                pen += width * scale * curves.Advance;
                earlier = isOwn ? character : null;
            }

            if (pen == from) continue;
            if (run.Marks.HasFlag(LineMarks.Underline)) lines.Add((from, pen, -0.2 * height));
            if (run.Marks.HasFlag(LineMarks.Overline)) lines.Add((from, pen, 1.2 * height));
            if (run.Marks.HasFlag(LineMarks.StrikeThrough)) lines.Add((from, pen, 0.5 * height));
        }

        return (letters, lines, pen);
    }

    /// <summary>The point of the line that is at the alignment point: groups 72 and 73.</summary>
    private (double X, double Y) AnchorOf(FontMetrics metrics)
    {
        if (_written.Horizontal == 4)
        {
            var (low, high) = Letters.Aggregate((Low: double.MaxValue, High: double.MinValue), (box, letter) => LetterExtents.Include(box, letter));
            return (0.5 * Advance, low > high ? 0.5 * Height : 0.5 * (low + high));
        }

        var part = _written.Horizontal switch { 1 => 0.5, 2 => 1.0, _ => 0.0 };
        var above = _written.Vertical switch { 1 => -metrics.Descent / metrics.CapHeight, 2 => 0.5, 3 => 1.0, _ => 0.0 };
        return (part * Advance, above * Height);
    }

    /// <summary>The arbitrary axis algorithm of the DXF reference.</summary>
    internal static (Vector3D X, Vector3D Y, Vector3D Z) AxesOf(Vector3D extrusion)
    {
        var length = Math.Sqrt((extrusion.X * extrusion.X) + (extrusion.Y * extrusion.Y) + (extrusion.Z * extrusion.Z));
        if (length == 0.0) return (new(1.0, 0.0, 0.0), new(0.0, 1.0, 0.0), new(0.0, 0.0, 1.0));
        var (nx, ny, nz) = (extrusion.X / length, extrusion.Y / length, extrusion.Z / length);
        var (ax, ay, az) = Math.Abs(nx) < 1.0 / 64.0 && Math.Abs(ny) < 1.0 / 64.0 ? (nz, 0.0, -nx) : (-ny, nx, 0.0);
        var across = Math.Sqrt((ax * ax) + (ay * ay) + (az * az));
        (ax, ay, az) = (ax / across, ay / across, az / across);
        return (new(ax, ay, az), new((ny * az) - (nz * ay), (nz * ax) - (nx * az), (nx * ay) - (ny * ax)), new(nx, ny, nz));
    }

    /// <param name="Pen">Of its origin, from the start of the line, drawing units before the inserts.</param>
    /// <param name="Scale">Drawing units of a font unit.</param>
    /// <param name="IsOutline">Where it overlaps its neighbours it is united with them.</param>
    internal sealed record Letter(GlyphCurves Curves, double Pen, double Scale, bool IsOutline)
    {
        /// <summary>Of its origin above the baseline, as <see cref="Pen"/>; 0 for a letter that is not joined.</summary>
        public double Rise { get; init; }

        /// <summary>Width as a multiple of the font's, where letters of a text differ.</summary>
        public double Width { get; init; } = 1.0;

        /// <summary>Displacement to the right for each unit above the letter's own origin, where letters of a text differ.</summary>
        public double Slope { get; init; }
    }
}
