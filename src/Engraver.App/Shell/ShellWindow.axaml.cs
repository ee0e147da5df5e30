using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Interactivity;
using Avalonia.Threading;
using Avalonia.VisualTree;
using Engraver.App.Binding;
using Engraver.App.Canvas;
using Engraver.App.Desk;
using Engraver.App.FileDialogs;
using Engraver.App.HandMoves;
using Engraver.App.Menus;
using Engraver.App.Options;
using Engraver.App.Properties;
using Engraver.App.Safety;
using Engraver.App.SectionBreaks;
using Engraver.App.StartPage;
using Engraver.App.Terminals;
using Engraver.App.TextOffers;

namespace Engraver.App.Shell;

/// <summary>The window of the desktop. Typed keys go to the command line, unless a text box has the focus.</summary>
public partial class ShellWindow : Window
{
    private readonly DesktopModel _desk;
    private readonly StopKeys _stopKeys;
    private readonly PanelSizes _panels;
    private readonly ClosingGuard _guard;

    public ShellWindow(DesktopModel desk, StopKeys stopKeys)
    {
        (_desk, _stopKeys) = (desk, stopKeys);
        InitializeComponent();
        DataContext = Model = new ShellModel(desk, CommandOfEntry);
        _guard = new ClosingGuard(desk, Model.Files, Close);
        var menus = new MenuBuilder(name => MenuTitle.ShortestInput(desk.Session, name), CommandOfEntry, new RecentMenu(Model.Recent, Model.StartPage.OpenRecent, CommandOfEntry("RECENT")));
        MainMenu.ItemsSource = menus.Build(MenuLayout.For(desk.Session.Catalog));
        Palettes.SetPages(Model.Palettes(), "Layers");
        Pages.SetPages(Model.Pages(), "Command");
        CanvasPlace.Child = Canvas;
        Canvas.Children.Add(new TextOfferView { Name = "TextOffer", DataContext = Model.TextOffer });
        Canvas.Children.Add(new SectionBreakView { Name = "SectionBreak", DataContext = Model.SectionBreak });
        Canvas.Children.Add(new StartPageView { Name = "StartSheet", DataContext = Model.StartPage });
        Canvas.Commands = new CanvasCommands(desk, Model.Command.Cancel, Model.Status.SetCursor, () => new CanvasMenu(desk, menus, Model.Command).Make(Bounds.Height).Open(Canvas));
        CanvasSource = new CanvasSource(desk, Canvas);
        _panels = new PanelSizes(desk, Middle, Rows, Columns, Pages, Palettes);
        OpeningSize.Apply(this, new Size(desk.Session.Settings.Current.WindowWidth, desk.Session.Settings.Current.WindowHeight));
        if (desk.Session.Settings.Current.WindowMaximised) WindowState = WindowState.Maximized;
        _ = new WindowPresence(this, desk);
        _ = new FileDrop(this, desk, Model.Files);
        Model.Files.Refused += _panels.ShowHistory;
        MainMenu.Closed += ReturnFocus;
        MainMenu.AddHandler(MenuItem.SubmenuOpenedEvent, (_, e) => MenuBuilder.Fit(e.Source as MenuItem, this));
        Pages.PageShown += (_, _) => FocusTerminal();
        stopKeys.Escaped += OnMachineHeld;
        Closed += (_, _) => stopKeys.Escaped -= OnMachineHeld;
        Model.Status.PropertyChanged += (_, _) => UpdateHint();
        Pages.PageShown += (_, _) => UpdateHint();
        Palettes.PageShown += (_, _) => UpdateHint();
        OptionsDialog.Serve(desk, Model.Options, this);
        AddHandler(TextInputEvent, OnTyped, RoutingStrategies.Tunnel);
        AddHandler(KeyDownEvent, OnKey, RoutingStrategies.Tunnel);
    }

    public ShellModel Model { get; }

    public DrawingCanvas Canvas { get; } = new();

    public CanvasSource CanvasSource { get; }

    /// <summary>The area of STOP in the window.</summary>
    public Rect StopArea => MachineStrip.StopAreaIn(this);

    /// <summary>The terminal if it is in front; null otherwise.</summary>
    private TerminalView? ShownTerminal => Pages.Current is { Key: "Terminal", Page: TerminalView terminal } && !_panels.ArePagesFolded ? terminal : null;

    /// <summary>A sheet is open over the window and has the keyboard.</summary>
    private bool IsSheetOpen => Model.Connect.IsOpen || Model.Options.IsOpen || Model.Files.Question.IsOpen || Model.Files.Dialog.IsOpen;

    protected override void OnClosing(WindowClosingEventArgs e)
    {
        base.OnClosing(e);
        if (_guard.PreventsClosing(e.CloseReason))
        {
            if (!Model.Files.Question.IsOpen) _panels.ShowHistory();
            e.Cancel = true;
            return;
        }

        _panels.Save();
        var maximised = WindowState == WindowState.Maximized;
        _desk.Session.Settings.Change(settings => maximised ? settings with { WindowMaximised = true } : settings with { WindowMaximised = false, WindowWidth = Width, WindowHeight = Height });
    }

    private void UpdateHint()
    {
        Pages.Hint(Model.HintFor(Pages.Current?.Key));
        Palettes.Hint(Model.HintFor(Palettes.Current?.Key));
    }

    /// <summary>The command of an entry in menus and tools.</summary>
    private RelayCommand CommandOfEntry(string name) => name switch
    {
        "QUIT" => new RelayCommand(() => Close()), // also during a script or a prompt, which continues if the window stays open
        "Window.Palettes" => new RelayCommand(() => _panels.FoldPalettes()),
        "Window.Pages" => new RelayCommand(() => _panels.FoldPages()),
        "Window.Clean" => new RelayCommand(() => _panels.FoldAll()),
        "Window.History" => new RelayCommand(() => _panels.ExpandHistory()),
        "Window.SelectAll" => new RelayCommand(SelectAll),
        "Window.EraseSelected" => new RelayCommand(EraseSelected),
        "Override.FeedFaster" => Model.Machine.Faster,
        "Override.FeedSlower" => Model.Machine.Slower,
        "Override.RapidsFaster" => Model.Machine.RapidsFaster,
        "Override.RapidsSlower" => Model.Machine.RapidsSlower,
        _ when name.StartsWith("Switch.", StringComparison.Ordinal) => Model.Status.Switches.First(toggle => toggle.Command == name["Switch.".Length..]).Switch,
        "CNCCONNECT" => new RelayCommand(AskForController),
        _ => new RelayCommand(() => _ = _desk.Queue.RunAsync(name)),
    };

    private void AskForController()
    {
        if (Model.Files.UsesDialogs) Model.Connect.Open();
        else _ = _desk.Queue.RunAsync("CNCCONNECT");
    }

    /// <summary>Selects all objects: as an answer at a prompt for objects, otherwise for the next command.</summary>
    private void SelectAll()
    {
        if (_desk.Prompt.Options.Any(option => option.Name == "ALL")) _ = _desk.Queue.EnterAsync("ALL");
        else if (_desk.Prompt.Command is null) _ = _desk.Queue.RunAsync("SELECT", "ALL", "");
    }

    private void EraseSelected()
    {
        if (_desk.Prompt.Command is null && _desk.Session.Document.Current.Selection.Count > 0) _ = _desk.Queue.RunAsync("ERASE");
    }

    /// <summary>Moves the focus from a closed menu to the command line.</summary>
    private void ReturnFocus(object? sender, RoutedEventArgs e)
    {
        if (FocusManager?.GetFocusedElement() is MenuItem) FocusManager.Focus(null);
    }

    /// <summary>Moves the focus from the command line, which stays visible, to the terminal in front; what is typed is for the terminal, also before its
    /// field is laid out.</summary>
    private void FocusTerminal()
    {
        if (ShownTerminal is not { } terminal) return;
        FocusManager?.Focus(null);
        terminal.TakeFocus();
    }

    /// <summary>True if a control that takes text itself has the focus: a text box, an open menu.</summary>
    private static bool HasTextFocus(object? source) => source is TextBox or MenuItem;

    /// <summary>True for a key that the focused control handles itself.</summary>
    private static bool Uses(object? source, Key key) => HasTextFocus(source)
        || (source is Slider or ComboBox or ComboBoxItem or IArrowKeyTarget && key is (Key.Left or Key.Right or Key.Up or Key.Down or Key.Home or Key.End or Key.PageUp or Key.PageDown))
        || (source is ComboBox { IsDropDownOpen: true } or ComboBoxItem && key is (Key.Enter or Key.Space));

    private void OnTyped(object? sender, TextInputEventArgs e)
    {
        if (TypeOnSheet(e)) return;
        if (HasTextFocus(e.Source) || IsSheetOpen || string.IsNullOrEmpty(e.Text)) return;
        e.Handled = true;
        if (ShownTerminal is { } terminal && _desk.Prompt.Command is null)
        {
            terminal.Type(e.Text);
            return;
        }

        _panels.ShowHistory();
        CommandLine.Type(e.Text);
    }

    /// <summary>A question takes all letters, the file dialog those that no text box takes.</summary>
    private bool TypeOnSheet(TextInputEventArgs e)
    {
        if (e.Text is not { Length: > 0 } text || !(Model.Files.Question.IsOpen || Model.Files.Dialog.IsOpen)) return false;
        if (Model.Files.Question.IsOpen) QuestionSheet.Type(text);
        else if (HasTextFocus(e.Source) && e.Source is not TextBox { Name: "LineBox" }) return true;
        else FileSheet.Type(text);
        return e.Handled = true;
    }

    /// <summary>Handles the keys of an open sheet, and keeps all others from the command line.</summary>
    private bool PressOnSheet(KeyEventArgs e)
    {
        if (Model.Files.Question.IsOpen) e.Handled = QuestionSheet.Press(e);
        else if (Model.Files.Dialog.IsOpen) e.Handled = FileSheet.Press(e);
        else if (Model.Connect.IsOpen) e.Handled = ConnectSheet.Press(e);
        else if (Model.Options.IsOpen) e.Handled = OptionsSheet.Press(e);
        else return false;
        return true;
    }

    /// <summary>Closes tips on the next key: a tip would cover the dialog that the key opens.</summary>
    private void CloseTips()
    {
        foreach (var control in this.GetVisualDescendants().OfType<Control>().Where(ToolTip.GetIsOpen).ToList()) ToolTip.SetIsOpen(control, false);
    }

    private void OnKey(object? sender, KeyEventArgs e)
    {
        e.Handled = _stopKeys.Press(e.Key, e.KeyModifiers);
        CloseTips();
        if (e.Handled || PressOnSheet(e) || e.Source is MenuItem || JogPad.Handles(e.Source, e.Key) || PropertyLinesView.Handles(e.Source, e.Key)) return;
        if (!HasTextFocus(e.Source) && e is { Key: Key.V, KeyModifiers: KeyModifiers.Control })
        {
            _panels.ShowHistory();
            _ = CommandLine.PasteAsync();
            e.Handled = true;
            return;
        }

        e.Handled = e.Key switch
        {
            Key.Escape when e.Source is ComboBox { IsDropDownOpen: true } or ComboBoxItem => false, // closes its list
            Key.Escape => Escape(),
            Key.Tab when e.KeyModifiers is KeyModifiers.None or KeyModifiers.Shift => Tab(e.Source),
            _ => CommandOf(e) is { } command ? Run(command) : !Uses(e.Source, e.Key) && e.KeyModifiers == KeyModifiers.None && PressElsewhere(e.Key),
        };
    }

    /// <summary>Handles a key while no control that uses keys has the focus; a button that was clicked before does not get it.</summary>
    private bool PressElsewhere(Key key)
    {
        if (ShownTerminal is { } terminal && _desk.Prompt.Command is null) return terminal.Press(key);
        if (key != Key.Space) return CommandLine.Press(key);
        _panels.ShowHistory();
        CommandLine.Type(" ");
        return true;
    }

    /// <summary>Tab accepts a suggestion. From a field it moves to the next field of the same page; from anywhere else the focus stays with the command
    /// line.</summary>
    /// <returns>True if handled; false leaves it to the fields.</returns>
    private bool Tab(object? source)
    {
        if (HasTextFocus(source) && source != CommandLine.LineBox) return ShownTerminal is not null && Pages.IsVisualAncestorOf((Visual)source!);
        if (Model.Command.HasSuggestions) CommandLine.Press(Key.Tab);
        else FocusCommandLine();
        return true;
    }

    /// <summary>Moves the focus to the command line: what is typed next arrives there.</summary>
    private void FocusCommandLine()
    {
        if (ShownTerminal is not null) _panels.ShowHistory();
        CommandLine.LineBox.Focus();
    }

    /// <summary>Esc has held the machine: a question that is asked during the job ends, the job does not.</summary>
    private void OnMachineHeld() => Dispatcher.UIThread.Post(() =>
    {
        Model.Command.Line = "";
        _ = _desk.Queue.EndConcurrentAsync();
        if (!IsSheetOpen) FocusCommandLine();
    });

    /// <summary>The command of a key; null for none, and for keys that edit text while a text box other than the empty command line has the
    /// focus.</summary>
    private string? CommandOf(KeyEventArgs e) =>
        ShellKeys.CommandOf(e) ?? (e.Source is TextBox box && (box != CommandLine.LineBox || box.Text is { Length: > 0 }) ? null : ShellKeys.CommandOutsideText(e));

    private bool Escape()
    {
        Canvas.Pointing.Escape();
        FocusCommandLine();
        return true;
    }

    private bool Run(string command)
    {
        CommandOfEntry(command).Execute(null);
        return true;
    }
}
