using Avalonia;
using Avalonia.Controls;
using Avalonia.Controls.Primitives;
using Avalonia.Input;
using Avalonia.Threading;
using Engraver.App.Desk;

namespace Engraver.App.Options;

/// <summary>A sheet over the window below the machine strip: STOP stays beside it.</summary>
public partial class OptionsView : UserControl
{
    public OptionsView()
    {
        InitializeComponent();
        OptionPages.ContainerPrepared += (_, e) => e.Container.Focusable = true; // rows of lists take no keyboard elsewhere (Theme/Controls.axaml)
        OptionPages.SelectionChanged += (_, _) => TabGoesToShownPage();
    }

    private OptionsModel Model => (OptionsModel)DataContext!;

    /// <summary>Enter takes, also on a check box, which Space turns; Esc leaves. Everything else belongs to what has the keyboard.</summary>
    /// <returns>True when it was one of them.</returns>
    public bool Press(KeyEventArgs e)
    {
        if (e.Source is ComboBox { IsDropDownOpen: true } or ComboBoxItem) return false; // the keys are those of the open list
        if (e.Key == Key.Escape) Model.Cancel.Execute(null);
        else if (e.Key == Key.Enter && e.Source is not ((Button and not ToggleButton) or ComboBox or ComboBoxItem)) Model.Take.Execute(null);
        else return false;
        return true;
    }

    /// <summary>Tab goes to the page that is shown, from which the arrow keys go on, and not to the first of the list.</summary>
    private void TabGoesToShownPage()
    {
        if (OptionPages.SelectedItem is { } page) KeyboardNavigation.SetTabOnceActiveElement(OptionPages, OptionPages.ContainerFromItem(page));
    }

    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        ArgumentNullException.ThrowIfNull(change);
        base.OnPropertyChanged(change);
        if (change.Property == IsVisibleProperty && IsVisible) Dispatcher.UIThread.Post(() => SearchBox.Focus(), DispatcherPriority.Loaded);
    }
}

/// <summary>Opens the sheets of commands that have one, where the command session asks for it.</summary>
internal static class OptionsDialog
{
    /// <summary>As long as the window is open, OPTIONS opens its sheet instead of asking at the command line, and QUIT closes the window.</summary>
    public static void Serve(DesktopModel desk, OptionsModel options, Window window)
    {
        desk.Session.Dialogs = Show;
        window.Closed += (_, _) => desk.Session.Dialogs = null;

        bool Show(string command)
        {
            Action? open = command switch { "OPTIONS" => options.Open, "QUIT" => window.Close, _ => null };
            if (open is not null) Dispatcher.UIThread.Post(open);
            return open is not null;
        }
    }
}
