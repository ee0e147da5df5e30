using Engraver.Core.Diagnostics;

namespace Engraver.Core.Dxf.Records;

/// <summary>The linetypes that have gaps: their curves are displayed dashed but cut as continuous lines.</summary>
internal sealed class LinetypeTable(NameTable names, LayerTable layers)
{
    private readonly HashSet<int> _dashed = [];

    /// <summary>Takes an LTYPE entry: 40 is the length of its pattern, 0 for one without gaps.</summary>
    public void Define(EntityRecord entry)
    {
        if (entry.Name >= 0 && entry.Number(40, 0.0) > 0.0) _dashed.Add(entry.Name);
    }

    /// <summary>The finding about a visible curve that is drawn dashed, by its own linetype or its layer's; null for any other curve.</summary>
    public RecordIssue? Find(EntityRecord record)
    {
        if (_dashed.Count == 0 || record.Invisible || !layers.IsCut(record.Layer)) return null;
        var linetype = record.Linetype < 0 || names[record.Linetype].Equals("BYLAYER", StringComparison.OrdinalIgnoreCase) ? layers.LinetypeOf(record.Layer) : record.Linetype;
        return _dashed.Contains(linetype) ? record.Finding(DxfRules.Dashed, names[linetype], refused: false) : null;
    }
}
