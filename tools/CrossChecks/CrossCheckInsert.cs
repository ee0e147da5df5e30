namespace Engraver.Tools.CrossChecks;

/// <summary>An INSERT that is being drawn: the current copy of its block, and its next record.</summary>
internal sealed class CrossCheckInsert
{
    private const int MaxRepeatsPerAxis = short.MaxValue;
    private readonly CrossCheckFrame _own;
    private readonly CrossCheckPoint _place;
    private readonly (double X, double Y, double Z) _scale;
    private readonly (double Cos, double Sin) _turn;
    private readonly (double Right, double Up) _step;
    private readonly int _columns;
    private long _copy = -1;
    private int _next;

    public CrossCheckInsert(CrossCheckRecord insert, CrossCheckBlock block, CrossCheckFrame outer)
    {
        Block = block;
        var angle = insert.Number(50, 0.0) * Math.PI / 180.0;
        _turn = (Math.Cos(angle), Math.Sin(angle));
        (_own, _place) = (outer.Compose(CrossCheckFrame.FromExtrusion(insert)), insert.Point(10));
        _scale = (insert.Number(41, 1.0), insert.Number(42, 1.0), insert.Number(43, 1.0));
        _step = (insert.Number(44, 0.0), insert.Number(45, 0.0));
        _columns = Repeats(insert.Number(70, 1.0));
        Copies = (long)_columns * Repeats(insert.Number(71, 1.0));
        _next = block.Content.Count;
    }

    public CrossCheckBlock Block { get; }

    public long Copies { get; }

    /// <summary>The coordinate system of the current copy.</summary>
    public CrossCheckFrame Frame { get; private set; }

    /// <summary>The next record to draw; null after the last copy.</summary>
    public CrossCheckRecord? Next()
    {
        if (_next == Block.Content.Count)
        {
            if (_next == 0 || ++_copy == Copies) return null;
            _next = 0;
            Frame = FrameOf(_copy % _columns * _step.Right, _copy / _columns * _step.Up);
        }

        return Block.Content[_next++];
    }

    private static int Repeats(double count) => count >= 1.0 ? (int)Math.Min(count, MaxRepeatsPerAxis) : 1;

    private CrossCheckFrame FrameOf(double right, double up)
    {
        var (cos, sin) = _turn;
        var corner = _place + new CrossCheckPoint((right * cos) - (up * sin), (right * sin) + (up * cos), 0.0);
        var scaled = new CrossCheckFrame(_scale.X * new CrossCheckPoint(cos, sin, 0.0), _scale.Y * new CrossCheckPoint(-sin, cos, 0.0), _scale.Z * new CrossCheckPoint(0.0, 0.0, 1.0), corner);
        var inside = _own.Compose(scaled);
        return inside with { Origin = inside.At((-1.0) * Block.Base) };
    }
}
