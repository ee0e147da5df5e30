namespace Engraver.Fonts.Strokes;

/// <summary>Reads the drawn shapes and the compositions of a stroke font. Shapes may refer to shapes of later lines.</summary>
internal sealed class StrokeFontReader
{
    private const string MetricsWord = "metrics";
    private const string MarkWord = "mark";

    private readonly Dictionary<int, StrokeLine> _drawn = [];
    private readonly Dictionary<int, StrokeLine> _composed = [];
    private readonly Dictionary<int, StrokeShape> _shapes = [];
    private readonly HashSet<int> _open = [];
    private FontMetrics? _metrics;

    public FontMetrics Metrics { get; private set; }

    /// <summary>Glyphs and marks by code point.</summary>
    public IReadOnlyDictionary<int, StrokeShape> Shapes => _shapes;

    /// <exception cref="StrokeFontException">A line cannot be read.</exception>
    public static StrokeFontReader Read(string shapesName, TextReader shapes, string compositionsName, TextReader compositions)
    {
        var reader = new StrokeFontReader();
        foreach (var line in StrokeLine.In(shapesName, shapes)) reader.Declare(line);
        foreach (var line in StrokeLine.In(compositionsName, compositions)) reader.DeclareComposition(line);
        reader.Metrics = reader._metrics ?? throw new StrokeFontException(StrokeFault.NoMetrics, shapesName, 0, MetricsWord);
        foreach (var (code, line) in reader._drawn.Concat(reader._composed)) reader.ShapeOf(code, line);
        return reader;
    }

    private void Declare(StrokeLine line)
    {
        var words = StrokeLine.Words(line.Text);
        if (words[0] == MetricsWord) DeclareMetrics(line, words);
        else Declare(_drawn, line, words[0] == MarkWord && words.Length > 1 ? words[1] : words[0]);
    }

    private void DeclareMetrics(StrokeLine line, string[] words)
    {
        if (words.Length != 6) throw line.Fault(StrokeFault.Malformed, line.Text);
        if (_metrics is not null) throw line.Fault(StrokeFault.Duplicate, MetricsWord);
        var values = words[1..].Select(line.NumberOf).ToArray();
        if (values.Any(value => value <= 0)) throw line.Fault(StrokeFault.NoMetrics, line.Text);
        _metrics = new FontMetrics(values[0], values[1], values[2], values[3], values[4]);
    }

    private void DeclareComposition(StrokeLine line) => Declare(_composed, line, StrokeLine.Words(line.Text)[0]);

    private void Declare(Dictionary<int, StrokeLine> lines, StrokeLine line, string character)
    {
        var code = line.CharacterOf(character);
        if (_drawn.ContainsKey(code) || !lines.TryAdd(code, line)) throw line.Fault(StrokeFault.Duplicate, character);
    }

    private StrokeShape ShapeOf(StrokeLine user, string character)
    {
        var code = user.CharacterOf(character);
        return ShapeOf(code, _drawn.GetValueOrDefault(code) ?? _composed.GetValueOrDefault(code) ?? throw user.Fault(StrokeFault.NoSuchShape, character));
    }

    private StrokeShape ShapeOf(int code, StrokeLine line)
    {
        if (_shapes.TryGetValue(code, out var shape)) return shape;
        if (!_open.Add(code)) throw line.Fault(StrokeFault.Circular, line.Text);
        shape = _drawn.ContainsKey(code) ? Draw(line) : Compose(line);
        _open.Remove(code);
        _shapes.Add(code, shape);
        return shape;
    }

    private StrokeShape Draw(StrokeLine line)
    {
        // The colon of a shape has spaces on both sides; the character of a line may be a colon or a bar.
        var colon = line.Text.IndexOf(" :", StringComparison.Ordinal);
        var head = StrokeLine.Words(colon < 0 ? "" : line.Text[..colon]);
        if (head.Length != 3) throw line.Fault(StrokeFault.Malformed, line.Text);
        var body = line.Text[(colon + 2)..].Split('|');
        if (body.Length > 2) throw line.Fault(StrokeFault.Malformed, line.Text);
        var strokes = new StrokePen(line, character => ShapeOf(line, character)).Draw(body[0]);
        var anchors = Anchors(line, body.Length == 2 ? body[1] : "");
        if (head[0] == MarkWord)
        {
            if (strokes.Count == 0) throw line.Fault(StrokeFault.Misplaced, line.Text);
            return new StrokeShape(0, 0, head[2], strokes, anchors);
        }

        var points = strokes.SelectMany(stroke => stroke.Pieces).SelectMany(piece => piece.Extremes()).ToList();
        var (right, top) = points.Count == 0 ? (0, 0) : (points.Max(point => point.X), points.Max(point => point.Y));
        anchors.TryAdd("top", new FontPoint(right / 2, top));
        anchors.TryAdd("bottom", new FontPoint(right / 2, 0));
        var left = line.NumberOf(head[1]);
        var advance = left + right + line.NumberOf(head[2]);
        return advance > 0 ? new StrokeShape(left, advance, null, strokes, anchors) : throw line.Fault(StrokeFault.NoAdvance, head[0]);
    }

    private static Dictionary<string, FontPoint> Anchors(StrokeLine line, string text)
    {
        var words = StrokeLine.Words(text);
        var anchors = new Dictionary<string, FontPoint>(StringComparer.Ordinal);
        if (words.Length % 3 != 0) throw line.Fault(StrokeFault.Malformed, text);
        for (var i = 0; i < words.Length; i += 3)
        {
            if (!anchors.TryAdd(words[i], new FontPoint(line.NumberOf(words[i + 1]), line.NumberOf(words[i + 2])))) throw line.Fault(StrokeFault.Duplicate, words[i]);
        }

        return anchors;
    }

    private StrokeShape Compose(StrokeLine line)
    {
        var words = StrokeLine.Words(line.Text);
        if (words.Length < 3 || words[1] != "=") throw line.Fault(StrokeFault.Malformed, line.Text);
        var glyph = ShapeOf(line, words[2]);
        if (glyph.Mark is not null) throw line.Fault(StrokeFault.NoSuchShape, words[2]);
        var strokes = glyph.Strokes.ToList();
        // The last shape first.
        var placed = new Stack<(StrokeShape Shape, FontPoint At)>([(glyph, default(FontPoint))]);
        foreach (var word in words.Skip(3))
        {
            var (character, anchor) = word.Split('@') is [var before, var after] ? (before, after) : (word, null);
            var mark = ShapeOf(line, character);
            if (mark.Mark is null) throw line.Fault(StrokeFault.NoSuchShape, character);
            anchor ??= mark.Mark;
            var at = placed.Where(item => item.Shape.Anchors.ContainsKey(anchor)).Select(item => new FontPoint(item.At.X + item.Shape.Anchors[anchor].X, item.At.Y + item.Shape.Anchors[anchor].Y)).Take(1).ToList();
            if (at.Count == 0) throw line.Fault(StrokeFault.NoSuchAnchor, word);
            strokes.AddRange(mark.Strokes.Select(stroke => stroke.Placed(at[0].X, at[0].Y, 1)));
            placed.Push((mark, at[0]));
        }

        return glyph with { Strokes = strokes };
    }
}
