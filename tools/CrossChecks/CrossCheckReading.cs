namespace Engraver.Tools.CrossChecks;

/// <summary>Keeps the blocks of a file, then iterates over its entities and measures each immediately, so that model space is never in memory as a
/// whole.</summary>
internal sealed class CrossCheckReading
{
    private const int MaxCurves = 10_000_000;
    private readonly Dictionary<string, CrossCheckBlock> _blocks = new(StringComparer.OrdinalIgnoreCase);
    private readonly Stack<CrossCheckInsert> _open = new();
    private readonly HashSet<CrossCheckBlock> _path = [];
    private int _drawn;

    public CrossCheckTally Tally { get; } = new();

    public static CrossCheckTally Read(byte[] bytes)
    {
        var (file, reading) = (new CrossCheckFile(bytes), new CrossCheckReading());
        reading.CollectBlocks(file);
        reading.DrawEntities(file);
        return reading.Tally;
    }

    private void CollectBlocks(CrossCheckFile file)
    {
        CrossCheckBlock? block = null;
        foreach (var record in CrossCheckRecords.In(file, "BLOCKS"))
        {
            if (record.Type == "BLOCK") _blocks.TryAdd(record.Text(2), block = new CrossCheckBlock(new(record.Number(10, 0.0), record.Number(20, 0.0), record.Number(30, 0.0))));
            else if (record.Type is "ENDBLK" or "ENDSEC") block = null;
            else if (record.Type != "VERTEX") block?.Content.Add(record);
            else if (block is { Content: [.., { Type: "POLYLINE" } polyline] }) polyline.Vertices.Add(record);
        }
    }

    private void DrawEntities(CrossCheckFile file)
    {
        CrossCheckRecord? waiting = null; // the previous entity, which is drawn when the next one starts: a POLYLINE then has all its vertices
        foreach (var record in CrossCheckRecords.In(file, "ENTITIES"))
        {
            if (record.Type == "VERTEX")
            {
                if (waiting?.Type == "POLYLINE") waiting.Vertices.Add(record);
                continue;
            }

            if (waiting is not null) DrawEntity(waiting);
            waiting = record.Type is "SEQEND" ? null : record;
        }

        if (waiting is not null) DrawEntity(waiting);
        foreach (var name in (string[])["*MODEL_SPACE", "$MODEL_SPACE"])
        {
            foreach (var content in _blocks.GetValueOrDefault(name)?.Content ?? []) DrawEntity(content);
        }
    }

    private void DrawEntity(CrossCheckRecord record)
    {
        if (record.InPaperSpace) return;
        Draw(record, CrossCheckFrame.World);
        while (_open.TryPeek(out var insert))
        {
            if (insert.Next() is { } content)
            {
                Draw(content, insert.Frame);
                continue;
            }

            _path.Remove(_open.Pop().Block);
        }
    }

    private void Draw(CrossCheckRecord record, CrossCheckFrame frame)
    {
        Count(1);
        if (record.Type == "INSERT") Open(record, frame);
        else if (record.Pieces is { } pieces) Tally.Add(record.Type, pieces, frame);
    }

    private void Open(CrossCheckRecord record, CrossCheckFrame frame)
    {
        if (!_blocks.TryGetValue(record.Text(2), out var block)) return;
        if (!_path.Add(block)) throw new CrossCheckException(Wording.Get("CrossCheckReading.NestedInItself"));
        var insert = new CrossCheckInsert(record, block, frame);
        Count(insert.Copies);
        _open.Push(insert);
    }

    private void Count(long more)
    {
        if (_drawn + more > MaxCurves) throw new CrossCheckException(Wording.Get("CrossCheckReading.TooManyCurves", MaxCurves));
        _drawn += (int)more;
    }
}

/// <summary>A block as in the file.</summary>
internal sealed class CrossCheckBlock(CrossCheckPoint origin)
{
    public CrossCheckPoint Base { get; } = origin;

    public List<CrossCheckRecord> Content { get; } = [];
}
