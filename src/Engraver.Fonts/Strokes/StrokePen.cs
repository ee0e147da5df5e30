namespace Engraver.Fonts.Strokes;

/// <summary>Draws the strokes of a line of a stroke font. The commands are described in Data/shapes.txt.</summary>
internal sealed class StrokePen(StrokeLine line, Func<string, StrokeShape> shapeOf)
{
    private readonly List<Stroke> _strokes = [];
    private readonly List<StrokePiece> _pieces = [];
    private FontPoint? _at;

    /// <summary>Index and points of an arc whose bulge follows from the next piece.</summary>
    private StrokePiece? _pending;

    public IReadOnlyList<Stroke> Draw(string commands)
    {
        var words = new Queue<string>(StrokeLine.Words(commands));
        while (words.TryDequeue(out var command))
        {
            Execute(command, words);
        }

        Lift(false);
        return _strokes;
    }

    private void Execute(string command, Queue<string> words)
    {
        switch (command)
        {
            case "M":
                Lift(false);
                _at = Point(words);
                break;
            case "L":
                Add(new StrokePiece(From(command), Point(words), 0));
                break;
            case "A":
                var end = Point(words);
                var sweep = Number(words);
                if (sweep == 0 || Math.Abs(sweep) >= 360) throw line.Fault(StrokeFault.NoPiece, command);
                Add(new StrokePiece(From(command), end, Math.Tan(sweep * Math.PI / 720)));
                break;
            case "T":
                if (_pieces.Count == 0 || _pending is not null) throw line.Fault(StrokeFault.Misplaced, command);
                Add(StrokePiece.Leaving(From(command), Point(words), _pieces[^1].EndDirection));
                break;
            case "N":
                if (_pending is not null) throw line.Fault(StrokeFault.Misplaced, command);
                _pending = new StrokePiece(From(command), Point(words), 0);
                _at = _pending.Value.End;
                break;
            case "h" or "v":
                Quarter(From(command), Point(words), command);
                break;
            case "Z":
                Close();
                break;
            case "U":
                Lift(false);
                Use(words);
                break;
            default:
                throw line.Fault(StrokeFault.UnknownCommand, command);
        }
    }

    /// <summary>Two arcs whose common tangent meets the tangents of both ends at equal distances; one arc if width and height are equal.</summary>
    private void Quarter(FontPoint from, FontPoint to, string command)
    {
        var (width, height) = (Math.Abs(to.X - from.X), Math.Abs(to.Y - from.Y));
        if (width == 0 || height == 0) throw line.Fault(StrokeFault.NoPiece, command);
        var (right, up) = (Math.Sign(to.X - from.X), Math.Sign(to.Y - from.Y));
        FontPoint horizontal = new(right, 0), vertical = new(0, up);
        var (leave, arrive) = command == "h" ? (horizontal, vertical) : (vertical, horizontal);
        var leaving = Math.Atan2(leave.Y, leave.X);
        if (width == height)
        {
            Add(StrokePiece.Leaving(from, to, leaving));
            return;
        }

        var reach = (-(width + height) + Math.Sqrt(((width + height) * (width + height)) + (2 * ((width * width) + (height * height))))) / 2;
        var joint = new FontPoint((from.X + (reach * leave.X) + to.X - (reach * arrive.X)) / 2, (from.Y + (reach * leave.Y) + to.Y - (reach * arrive.Y)) / 2);
        Add(StrokePiece.Leaving(from, joint, leaving));
        Add(StrokePiece.Leaving(to, joint, Math.Atan2(-arrive.Y, -arrive.X)).Reversed());
    }

    private void Add(StrokePiece piece)
    {
        if (piece.Start == piece.End || !double.IsFinite(piece.Bulge)) throw line.Fault(StrokeFault.NoPiece, line.Text);
        if (_pending is { } before)
        {
            _pending = null;
            Add(StrokePiece.Leaving(before.End, before.Start, piece.StartDirection + Math.PI).Reversed());
        }

        _pieces.Add(piece);
        _at = piece.End;
    }

    private void Close()
    {
        if (_pieces.Count == 0) throw line.Fault(StrokeFault.Misplaced, "Z");
        if (_at != _pieces[0].Start) Add(new StrokePiece(_at!.Value, _pieces[0].Start, 0));
        Lift(true);
    }

    private void Lift(bool isClosed)
    {
        if (_pending is not null || (_at is not null && _pieces.Count == 0)) throw line.Fault(StrokeFault.Misplaced, line.Text);
        if (_pieces.Count > 0) _strokes.Add(new Stroke([.. _pieces], isClosed));
        _pieces.Clear();
        _at = null;
    }

    private void Use(Queue<string> words)
    {
        var shape = shapeOf(Next(words));
        var (x, y) = (Number(words), Number(words));
        var scale = words.TryPeek(out var word) && (char.IsAsciiDigit(word[0]) || word[0] is '.' or '-') ? Number(words) : 1;
        if (scale <= 0) throw line.Fault(StrokeFault.NotANumber, word!);
        _strokes.AddRange(shape.Strokes.Select(stroke => stroke.Placed(x, y, scale)));
    }

    private FontPoint From(string command) => _at ?? throw line.Fault(StrokeFault.Misplaced, command);

    private FontPoint Point(Queue<string> words) => new(Number(words), Number(words));

    private double Number(Queue<string> words) => line.NumberOf(Next(words));

    private string Next(Queue<string> words) => words.TryDequeue(out var word) ? word : throw line.Fault(StrokeFault.Malformed, line.Text);
}
