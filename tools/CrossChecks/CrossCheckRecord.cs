namespace Engraver.Tools.CrossChecks;

/// <summary>An entity with its tags, and the vertices that follow a POLYLINE.</summary>
internal sealed class CrossCheckRecord(CrossCheckFile file, string type)
{
    private List<CrossCheckPiece>? _pieces;
    private bool _tried;

    public string Type { get; } = type;

    public List<CrossCheckTag> Tags { get; } = [];

    public List<CrossCheckRecord> Vertices { get; } = [];

    public bool InPaperSpace => Number(67, 0.0) == 1.0;

    /// <summary>Its smooth pieces; null when it is not a curve or one of its numbers is not a number.</summary>
    public IReadOnlyList<CrossCheckPiece>? Pieces
    {
        get
        {
            if (!_tried) _pieces = CrossCheckCurves.Read(this);
            if (_pieces is { } found && found.Exists(piece => double.IsNaN(piece.At(0.5).To(default)))) _pieces = null;
            _tried = true;
            return _pieces;
        }
    }

    public string Text(int code)
    {
        foreach (var tag in Tags)
        {
            if (tag.Code == code) return file.Text(tag);
        }

        return "";
    }

    public double Number(int code, double otherwise)
    {
        foreach (var tag in Tags)
        {
            if (tag.Code == code) return file.Number(tag);
        }

        return otherwise;
    }

    public double Number(CrossCheckTag tag) => file.Number(tag);

    public double[] Numbers(int code) => [.. Tags.Where(tag => tag.Code == code).Select(file.Number)];

    public CrossCheckPoint Point(int code) => new(Number(code, double.NaN), Number(code + 10, double.NaN), Number(code + 20, 0.0));
}
