using System.Windows.Input;
using Engraver.App.Alarms;
using Engraver.App.Binding;
using Engraver.App.CommandWindow;
using Engraver.App.Commissioning;
using Engraver.App.Connections;
using Engraver.App.Contours;
using Engraver.App.Desk;
using Engraver.App.FileDialogs;
using Engraver.App.Findings;
using Engraver.App.HandMoves;
using Engraver.App.Histories;
using Engraver.App.Jobs;
using Engraver.App.Layers;
using Engraver.App.MachineStrip;
using Engraver.App.Operations;
using Engraver.App.Options;
using Engraver.App.Playback;
using Engraver.App.Plots;
using Engraver.App.Programs;
using Engraver.App.Properties;
using Engraver.App.SectionBreaks;
using Engraver.App.StartPage;
using Engraver.App.StatusBar;
using Engraver.App.Tables;
using Engraver.App.Tabs;
using Engraver.App.Terminals;
using Engraver.App.TextOffers;
using Engraver.App.Texts;
using Engraver.App.Trajectories;
using Engraver.Workbench.Machines;

namespace Engraver.App.Shell;

/// <summary>The state of the main window: its parts, each with its own model, and its title.</summary>
public sealed class ShellModel : ObservableObject
{
    private readonly PageTab _alarms;

    /// <param name="commandOf">Returns the command of a menu entry or a tool; the window supplies it, because some commands need a file dialog.</param>
    public ShellModel(DesktopModel desk, Func<string, ICommand> commandOf)
    {
        Desk = desk;
        Machine = new MachineStripModel(desk);
        Status = new StatusBarModel(desk);
        Command = new CommandWindowModel(desk);
        Playback = new PlaybackModel(desk);
        Connect = new ConnectModel(desk);
        Options = new OptionsModel(desk);
        Files = new FileQuestions(desk, Command.TakeLine);
        Recent = new RecentDrawings(desk);
        TextOffer = new TextOfferModel(desk);
        SectionBreak = new SectionBreakModel(desk);
        StartPage = new StartPageModel(desk, Files, Recent, commandOf("OPEN"));
        Tools = ToolColumn.For(desk, commandOf);
        _alarms = new PageTab("Alarms", () => new AlarmsView { DataContext = new AlarmsModel(desk) });
        desk.Notifications.Changed += Refresh;
    }

    public DesktopModel Desk { get; }

    public MachineStripModel Machine { get; }

    public StatusBarModel Status { get; }

    public CommandWindowModel Command { get; }

    public PlaybackModel Playback { get; }

    /// <summary>The sheet that asks for the controller's address.</summary>
    public ConnectModel Connect { get; }

    /// <summary>The sheet of the settings.</summary>
    public OptionsModel Options { get; }

    /// <summary>The file dialog, and the questions before a file is replaced or edits are lost.</summary>
    public FileQuestions Files { get; }

    public RecentDrawings Recent { get; }

    /// <summary>The offer to engrave texts that would not be cut.</summary>
    public TextOfferModel TextOffer { get; }

    /// <summary>The question at a change of the tool or a stop between repeats.</summary>
    public SectionBreakModel SectionBreak { get; }

    /// <summary>The start page on the empty canvas.</summary>
    public StartPageModel StartPage { get; }

    public IReadOnlyList<ToolButton> Tools { get; }

    /// <summary>Drawing and machine, which the task bar also shows.</summary>
    public string Title
    {
        get
        {
            var file = Path.GetFileName(Desk.Session.Document.FilePath);
            if (Desk.Session.Machine.Status.State is not MachineState.Offline and var state) return Text.Get("Window.TitleWithMachine", file ?? Text.Get("Window.NoDrawing"), state.DisplayText());
            return file is null ? Text.Get("Window.Title") : Text.Get("Window.TitleOf", file);
        }
    }

    /// <summary>The palettes at the right; created when first shown.</summary>
    public IReadOnlyList<PageTab> Palettes() =>
    [
        new("Layers", () => new LayersView { DataContext = new LayersModel(Desk) }),
        new("Properties", () => new PropertiesView { DataContext = new PropertiesModel(Desk) }),
        new("Contours", () => new ContoursView { DataContext = new ContoursModel(Desk) }),
        new("Operations", () => new OperationsView { DataContext = new OperationsModel(Desk) }),
        new("Job", () => new JobView { DataContext = new JobModel(Desk) }),
        new("Program", () => new ProgramView { DataContext = new ProgramModel(Desk) }),
        new("Machine", () => new HandMovesView { DataContext = new HandMovesModel(Desk) }),
        new("Commissioning", () => new CommissioningView { DataContext = new CommissioningModel(Desk) }),
        new("Plots", () => new PlotsView { DataContext = new PlotsModel(Desk) }),
    ];

    /// <summary>The pages at the bottom.</summary>
    public IReadOnlyList<PageTab> Pages() =>
    [
        new("Command", () => new CommandWindowView { DataContext = Command }),
        new("Table", () => new TableView { DataContext = new TableModel(Desk) }),
        new("Trajectories", () => new TrajectoriesView { DataContext = new TrajectoriesModel(Desk) }),
        new("Findings", () => new FindingsView { DataContext = new FindingsModel(Desk) }),
        _alarms,
        new("History", () => new HistoryView { DataContext = new HistoryModel(Desk) }),
        new("Terminal", () => new TerminalView { DataContext = new TerminalModel(Desk) }),
    ];

    /// <summary>A line over a page that shows derived results, while these are not complete; empty for none.</summary>
    public string HintFor(string? page)
    {
        var derivation = Desk.Session.Derivation;
        if (page is not ("Contours" or "Operations" or "Job" or "Program" or "Plots" or "Table") || Desk.Session.Document.Current.Drawing is null || derivation.IsCurrent) return "";
        return derivation.IsCancelled ? Text.Get("Tabs.PlanningCancelled") : Status.IsWorking && derivation.Progress.Stage is { } stage ? Text.Get("Tabs.Planning", stage.Name) : "";
    }

    private void Refresh()
    {
        OnPropertyChanged(nameof(Title));
        _alarms.PendingCount = Desk.Session.Machine.Alarms.All.Count(alarm => alarm.NeedsAcknowledging);
    }
}
