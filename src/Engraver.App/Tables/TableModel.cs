using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.Core.EntityTables;

namespace Engraver.App.Tables;

/// <summary>The entity table in sequence order, however long. The row under the tool is chosen; choosing one moves the tool there.</summary>
public sealed class TableModel : Observable
{
    private readonly WorkDesk _desk;
    private EntityTable? _table;
    private int _current = -1;

    public TableModel(WorkDesk desk)
    {
        _desk = desk;
        desk.Changed += Look;
        desk.Derived.Moved += LookWhereToolIs;
        Look();
    }

    public RowList<TableRow> Rows { get; private set; } = new(0, _ => throw new ArgumentOutOfRangeException(nameof(Rows)), row => row.Index);

    public bool IsEmpty => Rows.Count == 0;

    /// <summary>The row under the tool; -1 for none.</summary>
    public int Current
    {
        get => _current;
        set
        {
            if (Set(ref _current, value) && value >= 0) _desk.Derived.MoveToRow(value);
        }
    }

    private void Look()
    {
        var table = _desk.Derived.Sequence?.Table;
        if (!ReferenceEquals(table, _table)) Show(table);
    }

    /// <summary>Shows a table, however long.</summary>
    internal void Show(EntityTable? table)
    {
        _table = table;
        Rows = new RowList<TableRow>(table?.Count ?? 0, index => new TableRow(table!, index), row => row.Index);
        Tell(nameof(Rows));
        Tell(nameof(IsEmpty));
        LookWhereToolIs();
    }

    private void LookWhereToolIs() => Set(ref _current, _desk.Derived.RowUnderTool, nameof(Current));
}
