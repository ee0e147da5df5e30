using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;

namespace Engraver.Core.Dxf.Records;

/// <summary>The linetypes with their patterns. Curves of those that have gaps are displayed dashed but cut as continuous lines, unless an operation cuts
/// dashes.</summary>
internal sealed class LinetypeTable(NameTable names, LayerTable layers)
{
    private readonly HashSet<int> _dashed = [];
    private readonly Dictionary<int, Linetype> _defined = [];

    /// <summary>Takes an LTYPE entry: 40 is the length of its pattern, 0 for one without gaps; 49 an element, 74 whether it has a text or shape.</summary>
    public void Define(EntityRecord entry)
    {
        if (entry.Name < 0) return;
        if (entry.Number(40, 0.0) > 0.0) _dashed.Add(entry.Name);
        _defined.TryAdd(entry.Name, new Linetype(names[entry.Name])
        {
            Elements = [.. entry.Sequence.Where(pair => pair.Code == 49).Select(pair => pair.Value)],
            HasShapes = entry.Sequence.Exists(pair => pair.Code == 74 && pair.Value != 0.0),
        });
    }

    /// <summary>The finding about a visible curve that is drawn dashed, by its own linetype or its layer's; null for any other curve.</summary>
    public RecordIssue? Find(EntityRecord record)
    {
        if (_dashed.Count == 0 || record.Invisible || !layers.IsCut(record.Layer)) return null;
        var linetype = record.Linetype == Linetype.ByLayer ? layers.LinetypeOf(record.Layer) : record.Linetype;
        return _dashed.Contains(linetype) ? record.Finding(DxfRules.Dashed, names[linetype], refused: false) : null;
    }

    /// <summary>Every linetype that the file names, by number; one that it does not define has no gaps.</summary>
    public IReadOnlyList<Linetype> ToLinetypes() => [.. names.ToList().Select((name, id) => _defined.GetValueOrDefault(id) ?? new Linetype(name))];
}
