using Engraver.Core.Drawings;
using Engraver.Core.Dxf.Blocks;
using Engraver.Core.Dxf.Records;

namespace Engraver.Core.Dxf;

/// <summary>Counts how every model-space record is handled while the file is read.</summary>
internal sealed class ReadTally(ImportLog log)
{
    private readonly Dictionary<string, int> _counts = new(StringComparer.Ordinal);
    private readonly List<int> _perLayer = [];
    private readonly List<RefusedEntity> _refused = [];
    private readonly List<RefusedEntity> _refusedInBlocks = [];
    private readonly Dictionary<string, long> _annotations = new(StringComparer.Ordinal);
    private string _runType = "";
    private int _run;
    private int _cut;
    private int _construction;

    /// <summary>Number of records that were not refused.</summary>
    public int Accepted => _cut + _construction;

    public void AddCut(EntityRecord record)
    {
        AddRecord(record);
        _cut++;
    }

    public void AddConstruction(EntityRecord record)
    {
        AddRecord(record);
        _construction++;
    }

    public void AddRefused(EntityRecord record, in RecordIssue issue)
    {
        AddRecord(record);
        _refused.Add(log.Refusal(issue));
        log.Add(issue);
    }

    /// <summary>A finding inside a block: listed among the refusals only when the entity was left out.</summary>
    public void AddInBlock(in RecordIssue issue)
    {
        if (issue.Refused) _refusedInBlocks.Add(log.Refusal(issue));
        log.Add(issue);
    }

    public void AddAnnotation(string type, long count) => _annotations[type] = BlockWeight.Sum(_annotations.GetValueOrDefault(type), count);

    public void AddAnnotations(IReadOnlyDictionary<string, long> annotations, long copies) => BlockWeights.AddAnnotations(_annotations, annotations, copies);

    public ReadBalance ToReadBalance(int layers)
    {
        EndRun("");
        while (_perLayer.Count < layers) _perLayer.Add(0);
        var texts = _annotations.Where(entry => entry.Key != "POINT").ToDictionary(entry => entry.Key, entry => Count(entry.Value), StringComparer.Ordinal);
        return new ReadBalance(_counts, _cut, _construction, _refused, _refusedInBlocks, texts, Count(_annotations.GetValueOrDefault("POINT")))
        {
            RecordsPerLayer = _perLayer,
        };
    }

    private static int Count(long count) => (int)Math.Min(count, int.MaxValue);

    /// <summary>Counts a record. Records of one type follow each other, so equal types are counted before the type is looked up.</summary>
    private void AddRecord(EntityRecord record)
    {
        if (!ReferenceEquals(record.Type, _runType)) EndRun(record.Type);
        _run++;
        while (_perLayer.Count <= record.Layer) _perLayer.Add(0);
        _perLayer[record.Layer]++;
    }

    private void EndRun(string nextType)
    {
        if (_run > 0) _counts[_runType] = _counts.GetValueOrDefault(_runType) + _run;
        (_runType, _run) = (nextType, 0);
    }
}
