namespace Engraver.Core.SecondOpinions;

/// <summary>Walks the tags of a file, keeps the blocks, and draws what stands in model space.</summary>
internal sealed class SecondReading
{
    private const int MostCurves = 200_000;
    private const int DeepestNesting = 250;
    private readonly Dictionary<string, (SecondPoint Base, List<SecondRecord> Content)> _blocks = new(StringComparer.OrdinalIgnoreCase);
    private readonly List<SecondRecord> _entities = [];
    private int _drawn;

    public SecondTally Tally { get; } = new();

    public static SecondTally Of(byte[] file)
    {
        var reading = new SecondReading();
        reading.Collect(file);
        foreach (var entity in reading._entities.Where(entity => !entity.InPaperSpace)) reading.Draw(entity, SecondFrame.World, 0);
        return reading.Tally;
    }

    private void Collect(byte[] file)
    {
        var (section, awaitsName) = ("", false);
        List<SecondRecord>? target = null;
        SecondRecord? record = null;
        foreach (var tag in SecondTags.Of(file))
        {
            if (awaitsName && tag.Code == 2) section = tag.Value.Trim().ToUpperInvariant();
            awaitsName = false;
            if (tag.Code != 0)
            {
                record?.Tags.Add(tag);
                continue;
            }

            Close(record, ref target);
            var type = tag.Value.Trim().ToUpperInvariant();
            awaitsName = type == "SECTION";
            record = section is "BLOCKS" or "ENTITIES" && type is not ("SECTION" or "ENDSEC") ? new SecondRecord(type) : null;
            if (type is "ENDSEC" or "EOF") (section, target) = ("", null);
            if (record is null || type is "BLOCK" or "ENDBLK" or "SEQEND") continue;
            if (section == "ENTITIES") target = _entities;
            if (type != "VERTEX") target?.Add(record);
            else if (target is { Count: > 0 } && target[^1].Type == "POLYLINE") target[^1].Vertices.Add(record);
        }

        Close(record, ref target);
    }

    /// <summary>A BLOCK is known by name once its own tags are complete.</summary>
    private void Close(SecondRecord? record, ref List<SecondRecord>? target)
    {
        if (record?.Type == "ENDBLK") target = null;
        if (record?.Type != "BLOCK") return;
        target = [];
        _blocks.TryAdd(record.Text(2), (new SecondPoint(record.Number(10, 0.0), record.Number(20, 0.0), record.Number(30, 0.0)), target));
    }

    private void Draw(SecondRecord record, SecondFrame frame, int depth)
    {
        if (++_drawn > MostCurves) throw new SecondOpinionException($"more than {MostCurves} curves and inserts");
        if (record.Type == "INSERT") Insert(record, frame, depth);
        else if (SecondCurves.Of(record) is { } pieces && pieces.TrueForAll(piece => !double.IsNaN(piece(0.5).To(default)))) Tally.Add(record.Type, pieces, frame);
    }

    private void Insert(SecondRecord insert, SecondFrame outer, int depth)
    {
        if (depth > DeepestNesting) throw new SecondOpinionException("blocks that are nested too deep or contain themselves");
        if (!_blocks.TryGetValue(insert.Text(2), out var block)) return;
        var angle = insert.Number(50, 0.0) * Math.PI / 180.0;
        var (cos, sin) = (Math.Cos(angle), Math.Sin(angle));
        var (own, place) = (SecondFrame.OfExtrusion(insert), insert.Point(10));
        var (columns, rows) = (Math.Max(1, (int)insert.Number(70, 1.0)), Math.Max(1, (int)insert.Number(71, 1.0)));
        for (var copy = 0; copy < columns * rows; copy++)
        {
            if (++_drawn > MostCurves) throw new SecondOpinionException($"more than {MostCurves} curves and inserts");
            var (right, up) = (copy % columns * insert.Number(44, 0.0), copy / columns * insert.Number(45, 0.0));
            var corner = place + new SecondPoint((right * cos) - (up * sin), (right * sin) + (up * cos), 0.0);
            var scaled = new SecondFrame(insert.Number(41, 1.0) * new SecondPoint(cos, sin, 0.0), insert.Number(42, 1.0) * new SecondPoint(-sin, cos, 0.0), insert.Number(43, 1.0) * new SecondPoint(0.0, 0.0, 1.0), corner);
            var inside = outer.Holding(own).Holding(scaled);
            inside = inside with { Origin = inside.At((-1.0) * block.Base) };
            foreach (var record in block.Content) Draw(record, inside, depth + 1);
        }
    }
}
