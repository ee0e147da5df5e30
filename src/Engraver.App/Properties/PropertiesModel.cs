using System.Globalization;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Tables;
using Engraver.App.Texts;
using Engraver.Core.Drawings;
using Engraver.Core.EntityTables;

namespace Engraver.App.Properties;

/// <summary>What is selected: type, layer, handle, and the 16 slots of each of its rows by name.</summary>
public sealed class PropertiesModel : Observable
{
    /// <summary>Most rows that are listed; further ones are only counted.</summary>
    private const int MostRows = 20;
    private readonly DesktopModel _desk;
    private (IReadOnlyList<int>? Selection, EntityTable? Table) _shown;

    public PropertiesModel(DesktopModel desk)
    {
        _desk = desk;
        desk.Changed += Look;
        Look();
    }

    public IReadOnlyList<PropertyLine> Lines { get; private set; } = [];

    public string Summary { get; private set; } = "";

    private void Look()
    {
        var (state, table) = (_desk.Session.Document.Current, _desk.Derived.Sequence?.Table);
        if (ReferenceEquals(state.Selection, _shown.Selection) && ReferenceEquals(table, _shown.Table)) return;
        _shown = (state.Selection, table);
        Summary = state.Selection.Count == 0 ? Text.Get("Properties.Nothing") : Text.Get("Properties.Selected", state.Selection.Count);
        Lines = state.Drawing is { } drawing && state.Selection.Count > 0 ? LinesOf(drawing, table, state.Selection) : [];
        Tell(null);
    }

    private static List<PropertyLine> LinesOf(Drawing drawing, EntityTable? table, IReadOnlyList<int> selection)
    {
        var lines = new List<PropertyLine>();
        var shown = 0;
        foreach (var entity in selection)
        {
            if (shown++ == MostRows) break;
            lines.AddRange(Head(drawing, entity));
            if (table is null) continue;
            foreach (var row in RowsOf(table, entity).Take(MostRows)) lines.AddRange(Slots(new TableRow(table, row)));
        }

        if (selection.Count > MostRows) lines.Add(new PropertyLine(Text.Get("Properties.More", Text.Count("Count.Object", selection.Count - MostRows)), "", IsHead: true));
        return lines;
    }

    private static IEnumerable<PropertyLine> Head(Drawing drawing, int index)
    {
        var entity = drawing.Entities[index];
        yield return new PropertyLine(entity.Type.ToDxfName(), drawing.SourceOf(index).Handle ?? "", IsHead: true);
        yield return new PropertyLine(Text.Get("Properties.Layer"), drawing.Layers[entity.Layer].Name);
        yield return new PropertyLine(Text.Get("Properties.Line"), entity.SourceLine.ToString(CultureInfo.InvariantCulture));
    }

    private static IEnumerable<PropertyLine> Slots(TableRow row)
    {
        yield return new PropertyLine(Text.Get("Properties.Row", row.Index + 1), "", IsHead: true);
        for (var slot = 0; slot < EntitySlot.Count; slot++) yield return new PropertyLine($"{SlotNames.NameOf(slot)} {SlotNames.UnitOf(slot)}".TrimEnd(), row.Figure(slot));
    }

    private static IEnumerable<int> RowsOf(EntityTable table, int entity) => Enumerable.Range(0, table.Count).Where(row => table.EntityIndexOf(row) == entity);
}

/// <summary>A name and its value.</summary>
/// <param name="IsHead">True: the beginning of an object.</param>
public sealed record PropertyLine(string Name, string Value, bool IsHead = false);
