using Avalonia.Controls;
using Avalonia.Input;

namespace Engraver.App.Terminals;

/// <summary>The page of the terminal.</summary>
public partial class TerminalView : UserControl
{
    public TerminalView() => InitializeComponent();

    /// <summary>Text that was typed elsewhere while this page is in front.</summary>
    public void Type(string text)
    {
        TakeFocus();
        if (DataContext is TerminalModel model) model.Line += text;
        LineBox.CaretIndex = LineBox.Text?.Length ?? 0;
    }

    /// <summary>A key that was pressed elsewhere.</summary>
    /// <returns>True if the terminal handled it.</returns>
    public bool Press(Key key)
    {
        if (key == Key.Space) Type(" ");
        else if (key == Key.Enter) TakeFocus(); // what is sent must be visible in the focused line
        else return false;
        return true;
    }

    public void TakeFocus() => LineBox.Focus();

    private async void OnKey(object? sender, KeyEventArgs e)
    {
        if (e.Key != Key.Enter || DataContext is not TerminalModel model) return;
        e.Handled = true;
        await model.SubmitAsync();
        if (LineList.ItemCount > 0) LineList.ScrollIntoView(LineList.ItemCount - 1);
    }
}
