using System.Collections.Concurrent;
using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Commissioning;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Origins;
using Engraver.Workbench.Playback;
using Engraver.Workbench.Plots;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Views;

namespace Engraver.Workbench.Commands;

/// <summary>The command line, as in AutoCAD: processes one input at a time, runs commands on the document and the machine, and shows the current
/// prompt.</summary>
/// <remarks>One caller at a time, except that concurrent commands (CNCSTOP, ZOOM, LIST) and <see cref="CancelAsync"/> may come from another caller. Prompts and
/// inputs follow hmi-conventions.md section 4.</remarks>
public sealed class CommandSession : IAsyncDisposable
{
    private readonly FrameStack _frames = new();
    private readonly ScriptQueue _scripts = new();
    private readonly SessionEvents _events;
    private ICommand? _last;
    private int _isEntering;

    public CommandSession(CommandEnvironment environment, CommandCatalog catalog)
    {
        Environment = environment;
        Catalog = catalog;
        Concurrent = new ConcurrentCommands(this, _frames);
        Machine = new MachineSession(environment.Time, MachineMemories.FolderIn(environment.RunJournalFolder), families: environment.Families);
        Plates = new PlateSession(CounterBook.In(environment.RunJournalFolder, environment.Time), environment.Time);
        Derivation = new DerivationSession(Document, Plates);
        History = new JobHistory(environment.KeepsHistory ? JobHistory.FolderIn(environment.RunJournalFolder) : null);
        Playback = new PlaybackSession(environment.Time);
        Plots = new PlotSession(Derivation, Machine);
        TypeAhead = new TypeAheadBuffer(this);
        Settings = new SettingsSession(environment.SettingsFile, environment.Time);
        Aliases = ReloadAliases();
        View.Change(state => SystemVariables.Restore(state, Settings.Current));
        _events = new SessionEvents(Document, Plates, Machine, Derivation, Playback, Certificates);
    }

    /// <summary>Raised for every line of the history, on the thread of the command.</summary>
    public event EventHandler<CommandMessage>? MessageWritten;

    /// <summary>Shows the dialog of the command with this name; false if there is none. Called on the thread of the command; null without a window.</summary>
    public Func<string, bool>? Dialogs { get; set; }

    public DocumentSession Document { get; } = new();

    public MachineSession Machine { get; }

    /// <summary>The view and its toggles.</summary>
    public ViewSession View { get; } = new();

    /// <summary>The persistent settings of the desktop.</summary>
    public SettingsSession Settings { get; }

    /// <summary>Results derived from the document: strokes, job, findings and plan.</summary>
    public DerivationSession Derivation { get; }

    /// <summary>The plates of the open drawing.</summary>
    public PlateSession Plates { get; }

    /// <summary>The certificate status of the document's job.</summary>
    public CertificateMonitor Certificates { get; } = new();

    /// <summary>The history of runs and posted programs.</summary>
    public JobHistory History { get; }

    /// <summary>Playback of the planned motion of the last derived document.</summary>
    public PlaybackSession Playback { get; }

    /// <summary>The plotted motions.</summary>
    public PlotSession Plots { get; }

    /// <summary>Progress of the AUTOSEQUENCE animation.</summary>
    public SequenceAnimation SequenceAnimation { get; } = new();

    /// <summary>The progress of the running command.</summary>
    public CommandProgress Progress { get; } = new();

    /// <summary>The steps of CNCCOMMISSION and their states.</summary>
    public CommissioningProgress Commissioning { get; } = new(() => CncCommissionCommand.StepNames);

    public CommandCatalog Catalog { get; }

    /// <summary>The command that Enter repeats; null if there is none or it starts motion.</summary>
    public string? RepeatableCommand => _last is { Info: { StartsMotion: false } info } ? info.Name : null;

    /// <summary>The commands that run beside the one at work.</summary>
    public ConcurrentCommands Concurrent { get; }

    /// <summary>Handles inputs typed while a command works.</summary>
    public TypeAheadBuffer TypeAhead { get; }

    public AliasTable Aliases { get; private set; }

    /// <summary>True while a command works without prompting.</summary>
    public bool IsBusy => Volatile.Read(ref _isEntering) != 0 || _frames.Top is { Pending: null };

    /// <summary>Name of the running command, the outermost one; null if none runs.</summary>
    public string? RunningCommand => _frames.Outermost?.Info.Name;

    /// <summary>The running command was cancelled (Esc) and has not ended yet.</summary>
    public bool IsEnding => IsBusy && _frames.Outermost is { IsCancelled: true };

    /// <summary>The current prompt.</summary>
    public PromptView Prompt
    {
        get
        {
            if (Concurrent.PromptingFrame is { Pending: { } question } beside) return View(beside, "", question.Prompt);
            return _frames.Top is { Pending: { } asks } frame ? View(frame, _frames.PromptPrefix, asks.Prompt) : PromptView.Idle;

            PromptView View(CommandFrame frame, string before, Prompt asks) =>
                new(frame.Info.Name, before + asks.TextIn(Settings.Current.Figures()), asks.Options, asks.Default, asks.AllowsSpaces, asks.PointRequest) { Preview = asks.Preview, TypedGhost = (asks as TextPrompt)?.TypedGhost, EditsDefault = asks is TextPrompt { EditsDefault: true }, FileRequest = asks.FileRequest, ConfirmsReplacing = asks.ConfirmsReplacing };
        }
    }

    /// <summary>The highlighted objects, indices into the drawing's entities: those picked for the running command, otherwise the selection.</summary>
    public IReadOnlyList<int> HighlightedEntities => _frames.Picked ?? Document.Current.Selection;

    /// <summary>Folder for relative file names.</summary>
    public string Folder => Environment.Folder;

    /// <summary>Folder of journals without an explicit path; null for the operator's data folder.</summary>
    public string? RunJournalFolder => Environment.RunJournalFolder;

    internal CommandEnvironment Environment { get; }

    /// <summary>The controller families that machine profiles may name and addresses may reach.</summary>
    public MachineFamilies Families => Environment.Families;

    /// <summary>A machine that is not simulated moves only after CNCARM; a simulated one also from a script or if the environment requires no arming.</summary>
    internal bool RunNeedsArming => !Machine.Connection.IsSimulation || (Environment.RunNeedsArming && !_scripts.IsRunnable);

    /// <summary>True when a script may not start the machine: at a desktop it may connect and arm, but only the operator starts a machine that is not
    /// simulated.</summary>
    internal bool RequiresManualStart => Environment.RunNeedsArming && _scripts.IsRunnable && !Machine.Connection.IsSimulation;

    /// <summary>True while inputs come from a script.</summary>
    internal bool IsScripted => _scripts.IsRunnable;

    /// <summary>Name of the outer command while a nested one runs; otherwise null.</summary>
    internal string? OuterCommand => _frames.IsNested ? _frames.Outermost!.Info.Name : null;

    /// <summary>A job runs or something moves: no input is kept to be run after it.</summary>
    internal bool IsMachineBusy => Machine.IsRunning || Machine.Status.State.IsMotion();

    internal bool TryOpenDialog(string command) => Dialogs?.Invoke(command) ?? false;

    /// <summary>Base point of direct distance entry (a number is measured towards the cursor), drawing units; null if no point is requested or it has no base
    /// point.</summary>
    public Point2D? DirectDistanceBase => _frames.Top is { Pending.Prompt: PointPrompt { Purpose: PointPurpose.Place, From: { } from } } ? from : null;

    internal Point2D LastPoint { get; set; }

    internal ConcurrentDictionary<string, string> LastValues { get; } = new(StringComparer.Ordinal);

    /// <summary>Processes one input, as typed up to Enter (or Space, if the prompt allows no spaces). Empty is Enter alone: the default, the end of a list, or
    /// the last command again.</summary>
    /// <param name="cancellation">The operator's stop: a running job is ended and the machine stopped before this returns.</param>
    public Task<InputResult> EnterAsync(string input, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(input);
        return EnterAsync(input.Trim(), input.Trim(), cancellation);
    }

    /// <summary>Processes a picked point with full precision; the history shows it with the display precision.</summary>
    /// <param name="cancellation">As for one input.</param>
    public Task<InputResult> PointAsync(Point2D place, CancellationToken cancellation) =>
        EnterAsync(string.Create(CultureInfo.InvariantCulture, $"{place.X:R},{place.Y:R}"), Settings.Current.Figures().FormatPoint(place), cancellation);

    private async Task<InputResult> EnterAsync(string input, string shown, CancellationToken cancellation)
    {
        Environment.Journal?.WriteLine(ScriptText.Write(input));
        if (Concurrent.HasPrompt || Interlocked.Exchange(ref _isEntering, 1) != 0) return ReportFailure(await Concurrent.EnterAsync(input, cancellation, shown).ConfigureAwait(false));
        try
        {
            var result = await EnterOneAsync(input, cancellation, shown).ConfigureAwait(false);
            return ReportFailure(_scripts.IsRunnable ? await RunScriptsAsync(cancellation).ConfigureAwait(false) : result);
        }
        finally
        {
            Volatile.Write(ref _isEntering, 0);
        }
    }

    /// <summary>Starts a nested command while another prompts, for keys and buttons. Typed commands have an apostrophe as prefix, which would be ambiguous in a
    /// text answer. Without a prompt it starts normally.</summary>
    /// <param name="cancellation">As for one input.</param>
    public async Task<InputResult> EnterNestedAsync(string command, CancellationToken cancellation)
    {
        if (_frames.Top is not { Pending: not null } frame) return await EnterAsync(command, cancellation).ConfigureAwait(false);
        if (Interlocked.Exchange(ref _isEntering, 1) != 0) return ReportFailure(await Concurrent.EnterAsync(command, cancellation).ConfigureAwait(false));
        try
        {
            Environment.Journal?.WriteLine("'" + command);
            Echo("'" + command);
            return ReportFailure(await StartNestedAsync(frame, command, cancellation).ConfigureAwait(false));
        }
        finally
        {
            Volatile.Write(ref _isEntering, 0);
        }
    }

    /// <summary>Processes several lines, such as pasted text, as a script. They are rejected while a command works.</summary>
    /// <param name="cancellation">As for one input.</param>
    public async Task<InputResult> EnterLinesAsync(string lines, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(lines);
        if (IsBusy || Interlocked.Exchange(ref _isEntering, 1) != 0) return ReportFailure(new InputResult.NotAccepted(Wording.Get("CommandSession.PasteWhileBusy")));
        try
        {
            Environment.Journal?.WriteLine(lines.TrimEnd());
            QueueScript(Wording.Get("CommandSession.PastedLines"), lines);
            return ReportFailure(await RunScriptsAsync(cancellation).ConfigureAwait(false));
        }
        finally
        {
            Volatile.Write(ref _isEntering, 0);
        }
    }

    /// <summary>Esc: ends the prompting command and clears the selection. A working command is cancelled (a job stops the machine first); its caller receives
    /// the result.</summary>
    public async Task CancelAsync()
    {
        if (await Concurrent.EndAsync().ConfigureAwait(false)) return;
        if (IsBusy)
        {
            _scripts.Clear();
            _frames.Cancel();
            WriteMessage(MessageKind.Note, Wording.Get("CommandSession.Cancel"));
            return;
        }

        SnapOverride.End(this);
        await EndAllAsync().ConfigureAwait(false);
        WriteMessage(MessageKind.Note, Wording.Get("CommandSession.Cancel"));
        if (Document.Current.Selection.Count > 0) Document.Select([], Document.Current.Previous);
    }

    /// <summary>Commands whose name or alias starts with the input; an exactly matching alias comes first.</summary>
    public IReadOnlyList<CommandSuggestion> Suggest(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        return CommandNames.Suggest(typed, Catalog, Aliases);
    }

    public async ValueTask DisposeAsync()
    {
        await Concurrent.EndAsync().ConfigureAwait(false);
        await EndAllAsync().ConfigureAwait(false);
        _events.Dispose();
        Derivation.Dispose();
        await Machine.DisposeAsync().ConfigureAwait(false);
    }

    internal void WriteMessage(MessageKind kind, string text) => MessageWritten?.Invoke(this, new CommandMessage(kind, text));

    /// <summary>Queues the inputs of a script. SCRIPT is not repeatable then, otherwise a blank line at the start of the script would run it again.</summary>
    internal void QueueScript(string path, string text)
    {
        _scripts.Add(path, text);
        _last = null;
    }

    /// <summary>A path for the journal of a run that starts now.</summary>
    public string NewRunJournal(string drawing) => Machines.Runs.JournalFolder.NewJournal(drawing, Environment.RunJournalFolder, Environment.Time);

    internal string ResolveInputPath(string name) => _scripts.ResolveInputPath(Environment.Folder, name);

    internal AliasTable ReloadAliases() => Aliases = AliasFiles.Read(Environment.AliasFile, Catalog);

    private async Task<InputResult> EnterOneAsync(string input, CancellationToken cancellation, string? shown = null)
    {
        if (_frames.Top is { Pending: null }) return await Concurrent.EnterAsync(input, cancellation, shown).ConfigureAwait(false);
        Echo(shown ?? input);
        if (_frames.Top is not { } frame) return await StartCommandAsync(input, cancellation).ConfigureAwait(false);
        if (input.StartsWith('\'') && frame.Pending is not { Prompt.AllowsSpaces: true }) return await StartNestedAsync(frame, input, cancellation).ConfigureAwait(false);
        if (SnapOverride.TrySet(this, frame.Pending, input)) return new InputResult.AwaitingInput();
        if (frame.Answer(input, LastPoint) is { } wanted) return new InputResult.NotAccepted(wanted);
        SnapOverride.End(this);
        return await SettleAsync(frame, cancellation).ConfigureAwait(false);
    }

    private async Task<InputResult> StartCommandAsync(string input, CancellationToken cancellation)
    {
        if (input.Length == 0) return await RepeatAsync(cancellation).ConfigureAwait(false);
        if (Find(input) is not { } command) return new InputResult.NotAccepted(Wording.Get("CommandSession.UnknownCommand", input));
        _last = command.Info.IsRepeatable ? command : null;
        return await StartAsync(command, cancellation, CommandPrefix.HasDash(input)).ConfigureAwait(false);
    }

    private async Task<InputResult> RepeatAsync(CancellationToken cancellation)
    {
        if (_last is not { } command) return new InputResult.Done();
        if (!command.Info.StartsMotion) return await StartAsync(command, cancellation).ConfigureAwait(false);
        WriteMessage(MessageKind.Note, Wording.Get("CommandSession.MotionNotRepeated", command.Info.Name));
        return new InputResult.Done();
    }

    private async Task<InputResult> StartNestedAsync(CommandFrame outer, string input, CancellationToken cancellation)
    {
        if (Find(input) is not { } command) return new InputResult.NotAccepted(Wording.Get("CommandSession.UnknownCommand", input));
        if (!command.Info.IsTransparent || _frames.IsNested) return new InputResult.NotAccepted(Wording.Get("CommandSession.CannotRunInside", command.Info.Name, outer.Info.Name));
        return await StartAsync(command, cancellation, CommandPrefix.HasDash(input)).ConfigureAwait(false);
    }

    /// <param name="hasNoDialog">A dash was typed before the name.</param>
    private async Task<InputResult> StartAsync(ICommand command, CancellationToken cancellation, bool hasNoDialog = false)
    {
        var frame = _frames.Push(command.Info, hasNoDialog);
        frame.Start(command, new CommandContext(this, frame));
        return await SettleAsync(frame, cancellation).ConfigureAwait(false);
    }

    private async Task<InputResult> SettleAsync(CommandFrame frame, CancellationToken cancellation)
    {
        var result = await _frames.WaitForPromptOrEndAsync(frame, cancellation).ConfigureAwait(false);
        if (result is not InputResult.Done || _frames.Top is not { } outer) return result;
        WriteMessage(MessageKind.Note, Wording.Get("CommandSession.ResumingCommand", outer.Info.Name));
        return new InputResult.AwaitingInput();
    }

    private Task EndAllAsync()
    {
        _scripts.Clear();
        return _frames.EndAllAsync();
    }

    private InputResult ReportFailure(InputResult result)
    {
        if (result is InputResult.Failed failed) WriteMessage(MessageKind.Error, failed.Message);
        if (result is InputResult.NotAccepted unclear) WriteMessage(MessageKind.Error, unclear.Message);
        return result;
    }

    internal void Echo(string input)
    {
        if (SystemVariables.Variable(Settings.Current, "CMDECHO") != 0.0) WriteMessage(MessageKind.Echo, $"{Prompt.Text} {input}".TrimEnd());
    }

    internal ICommand? Find(string input) => CommandNames.Find(input, Catalog, Aliases);

    /// <summary>Processes the queued inputs until a command fails or none is left.</summary>
    private async Task<InputResult> RunScriptsAsync(CancellationToken cancellation)
    {
        InputResult result = new InputResult.Done();
        while (_scripts.Next() is { } next)
        {
            result = cancellation.IsCancellationRequested ? new InputResult.Cancelled() : await EnterOneAsync(next.Token.Text, cancellation).ConfigureAwait(false);
            if (result is InputResult.AwaitingInput or InputResult.Done) continue;
            await EndAllAsync().ConfigureAwait(false);
            return next.WithLocation(result);
        }

        return result;
    }
}
