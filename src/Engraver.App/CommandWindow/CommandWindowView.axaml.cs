using Avalonia.Controls;
using Avalonia.Threading;

namespace Engraver.App.CommandWindow;

/// <summary>The page of the command window: all inputs and messages.</summary>
public partial class CommandWindowView : UserControl
{
    private bool _scrolling;

    public CommandWindowView()
    {
        InitializeComponent();
        HistoryList.Items.CollectionChanged += OnHistory;
        HistoryList.SizeChanged += OnHistory;
    }

    /// <summary>Scrolls to the last line, also when the available height changes; once for any number of new lines.</summary>
    private void OnHistory(object? sender, EventArgs e)
    {
        if (_scrolling) return;
        _scrolling = true;
        Dispatcher.UIThread.Post(ScrollToEnd, DispatcherPriority.Loaded);
    }

    private void ScrollToEnd()
    {
        _scrolling = false;
        if (HistoryList.ItemCount > 0) HistoryList.ScrollIntoView(HistoryList.ItemCount - 1);
    }
}
