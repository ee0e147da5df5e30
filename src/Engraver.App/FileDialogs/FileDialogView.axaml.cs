using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.Threading;

namespace Engraver.App.FileDialogs;

/// <summary>The file dialog: a sheet below the machine strip, so that STOP stays visible. The name field has the keyboard, but arrow keys move in the
/// list.</summary>
public partial class FileDialogView : UserControl
{
    private const int Page = 10;

    public FileDialogView()
    {
        InitializeComponent();
        FileList.PointerMoved += (_, e) => Model.Hover((e.Source as StyledElement)?.DataContext as FileRow);
        FileList.PointerExited += (_, _) => Model.Hover(null);
        FileList.SelectionChanged += (_, _) => ShowChoice();
        CrumbList.SizeChanged += (_, _) => CrumbScroll.Offset = new Vector(double.MaxValue, 0.0);
    }

    private FileDialogModel Model => (FileDialogModel)DataContext!;

    /// <summary>Text that was typed while another control had the focus.</summary>
    public void Type(string text)
    {
        Model.Name = Model.IsTyped ? Model.Name + text : text;
        TakeFocus();
        NameBox.CaretIndex = Model.Name.Length;
    }

    /// <summary>Handles the keys of the dialog; all other keys go to the focused control.</summary>
    /// <returns>True if the key was handled.</returns>
    public bool Press(KeyEventArgs e)
    {
        switch (e.Key, e.KeyModifiers)
        {
            case (Key.Escape, _) when !FilterList.IsDropDownOpen: Model.Cancel.Execute(null); return true;
            case (Key.Up, KeyModifiers.Alt): Model.Up.Execute(null); return true;
            case (Key.Back, KeyModifiers.None) when GoesUp(e.Source): Model.Up.Execute(null); return true;
            case (Key.Enter, KeyModifiers.None) when e.Source is not (Button or ComboBox or ComboBoxItem): Model.Accept.Execute(null); return true;
            default: return e.Source is not (ComboBox or ComboBoxItem) && e.KeyModifiers == KeyModifiers.None && Move(e.Key);
        }
    }

    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == IsVisibleProperty && IsVisible) Dispatcher.UIThread.Post(OnOpened, DispatcherPriority.Loaded);
    }

    private bool Move(Key key)
    {
        var rows = key switch { Key.Up => -1, Key.Down => 1, Key.PageUp => -Page, Key.PageDown => Page, _ => 0 };
        if (rows == 0) return false;
        Model.Move(rows);
        TakeFocus();
        return true;
    }

    /// <summary>Backspace deletes typed text; without any, it goes to the parent folder.</summary>
    private bool GoesUp(object? source) => source is not TextBox || Model.Name.Length == 0 || (!Model.IsTyped && Model.Chosen is not null);

    private void OnOpened()
    {
        TakeFocus();
        if (Model.IsTyped) NameBox.CaretIndex = Model.Name.Length;
        else NameBox.SelectAll();
    }

    private void TakeFocus() => NameBox.Focus();

    private void ShowChoice()
    {
        if (FileList.SelectedItem is not { } row) return;
        FileList.ScrollIntoView(row);
        if (!Model.IsTyped) NameBox.SelectAll();
    }

    private void OnPlace(object? sender, RoutedEventArgs e)
    {
        Model.GoToPlace.Execute(((Control)sender!).Tag);
        TakeFocus();
    }

    private void OnDoubleTapped(object? sender, TappedEventArgs e)
    {
        if ((e.Source as StyledElement)?.DataContext is not FileRow row) return;
        e.Handled = true;
        Model.Move(0);
        Model.Chosen = row;
        Model.Accept.Execute(null);
    }
}
