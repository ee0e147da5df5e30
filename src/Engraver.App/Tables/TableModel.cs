using Engraver.App.Desk;
using Engraver.Core.EntityTables;

namespace Engraver.App.Tables;

/// <summary>The entity table in sequence order; any length.</summary>
public sealed class TableModel : PlaybackRows<TableRow>
{
    private EntityTable? _table;

    public TableModel(DesktopModel desk)
        : base(desk, () => desk.Derived.RowUnderTool, desk.Derived.MoveToRow, row => row.Index) => Subscribe();

    /// <summary>Shows a table of any length.</summary>
    internal void Show(EntityTable? table)
    {
        _table = table;
        Show(table?.Count ?? 0, index => new TableRow(table!, index));
    }

    protected override void Refresh()
    {
        var table = Desk.Derived.Sequence?.Table;
        if (!ReferenceEquals(table, _table)) Show(table);
    }
}
