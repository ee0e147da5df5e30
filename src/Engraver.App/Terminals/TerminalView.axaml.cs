using Avalonia.Controls;
using Avalonia.Input;

namespace Engraver.App.Terminals;

/// <summary>The page of the terminal.</summary>
public partial class TerminalView : UserControl
{
    public TerminalView() => InitializeComponent();

    private async void OnKey(object? sender, KeyEventArgs e)
    {
        if (e.Key != Key.Enter || DataContext is not TerminalModel model) return;
        e.Handled = true;
        await model.SubmitAsync();
        if (LineList.ItemCount > 0) LineList.ScrollIntoView(LineList.ItemCount - 1);
    }
}
