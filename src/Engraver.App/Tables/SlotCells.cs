using System.Globalization;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Documents;
using Avalonia.Media;
using Engraver.Core.EntityTables;

namespace Engraver.App.Tables;

/// <summary>One line of the table drawn as one control: number and 16 cells, or their names. Scrolling creates no controls.</summary>
public sealed class SlotCells : Control
{
    public const double NumberWidth = 50;
    public const double CellWidth = 74;

    /// <summary>Includes a margin after the last cell.</summary>
    public const double AllWidth = NumberWidth + (EntitySlot.Count * CellWidth) + RoomAtTheEdge;

    private const double RoomAtTheEdge = 6;
    private const double UnitBelow = 6.5;

    public static readonly StyledProperty<TableRow?> RowProperty = AvaloniaProperty.Register<SlotCells, TableRow?>(nameof(Row));

    static SlotCells() => AffectsRender<SlotCells>(RowProperty, TextElement.ForegroundProperty, TextElement.FontSizeProperty);

    /// <summary>Null: the names of the slots, with their units under them.</summary>
    public TableRow? Row
    {
        get => GetValue(RowProperty);
        set => SetValue(RowProperty, value);
    }

    public override void Render(DrawingContext context)
    {
        if (Row is { } row)
        {
            Write(context, (row.Index + 1).ToString(CultureInfo.InvariantCulture), RightOf(-1), 0);
            for (var slot = 0; slot < EntitySlot.Count; slot++) Write(context, row.Figure(slot), RightOf(slot), 0);
            return;
        }

        Write(context, "#", RightOf(-1), -UnitBelow);
        for (var slot = 0; slot < EntitySlot.Count; slot++)
        {
            Write(context, SlotNames.NameOf(slot), RightOf(slot), -UnitBelow);
            Write(context, SlotNames.UnitOf(slot), RightOf(slot), UnitBelow);
        }
    }

    protected override Size MeasureOverride(Size availableSize) => new(AllWidth, 20);

    /// <summary>Right edge of the text of a slot; -1 is the number of the row.</summary>
    private static double RightOf(int slot) => NumberWidth + ((slot + 1) * CellWidth) - 10;

    /// <param name="below">From the middle line.</param>
    private void Write(DrawingContext context, string text, double right, double below)
    {
        var typeface = new Typeface(TextElement.GetFontFamily(this));
        var line = new FormattedText(text, CultureInfo.InvariantCulture, FlowDirection.LeftToRight, typeface, TextElement.GetFontSize(this), TextElement.GetForeground(this));
        context.DrawText(line, new Point(right - line.Width, ((Bounds.Height - line.Height) / 2) + below));
    }
}
