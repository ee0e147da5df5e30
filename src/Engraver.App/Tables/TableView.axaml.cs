using Avalonia.Controls;
using Avalonia.Media;

namespace Engraver.App.Tables;

/// <summary>The page of the entity table. The names of the slots stay visible and scroll sideways with the rows.</summary>
public partial class TableView : UserControl
{
    public TableView()
    {
        InitializeComponent();
        RowList.AddHandler(ScrollViewer.ScrollChangedEvent, (_, _) => Names.RenderTransform = new TranslateTransform(-(RowList.Scroll?.Offset.X ?? 0.0), 0.0));
    }
}
