using Avalonia.Controls;
using Avalonia.Input;

namespace Engraver.App.Histories;

/// <summary>The page of the history of jobs.</summary>
public partial class HistoryView : UserControl
{
    public HistoryView() => InitializeComponent();

    /// <summary>A double click on a job opens its drawing.</summary>
    private void OnDoubleTapped(object? sender, TappedEventArgs e)
    {
        if (DataContext is not HistoryModel { Chosen: not null } model) return;
        e.Handled = true;
        model.Open.Execute(null);
    }
}
