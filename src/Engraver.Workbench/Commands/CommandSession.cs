using System.Collections.Concurrent;
using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Commissioning;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Origins;
using Engraver.Workbench.Playback;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Views;

namespace Engraver.Workbench.Commands;

/// <summary>What the command line is to AutoCAD: takes one input at a time, runs commands on the document and the machine, and always says what it waits
/// for.</summary>
/// <remarks>One caller at a time, except that while a command is at work those that are heard beside it (CNCSTOP, ZOOM, LIST) and <see cref="CancelAsync"/>
/// may come from another. Reads and writes follow hmi-conventions.md section 4.</remarks>
public sealed class CommandSession : IAsyncDisposable
{
    private readonly FrameStack _frames = new();
    private readonly ScriptQueue _scripts = new();
    private readonly SessionTies _ties;
    private ICommand? _last;
    private int _taking;

    public CommandSession(CommandEnvironment environment, CommandCatalog catalog)
    {
        Environment = environment;
        Catalog = catalog;
        Beside = new BesideCommands(this, _frames);
        Machine = new MachineSession(environment.Time, MachineMemories.FolderIn(environment.RunJournalFolder));
        Derivation = new DerivationSession(Document);
        History = new JobHistory(environment.KeepsHistory ? JobHistory.FolderIn(environment.RunJournalFolder) : null);
        Playback = new PlaybackSession(environment.Time);
        Ahead = new TypedAhead(this);
        Settings = new SettingsSession(environment.SettingsFile, environment.Time);
        Aliases = ReloadAliases();
        View.Change(state => SystemVariables.Restore(state, Settings.Current));
        _ties = new SessionTies(Document, Machine, Derivation, Playback, Certificates);
    }

    /// <summary>Raised for every line of the history, on the thread of the command.</summary>
    public event EventHandler<CommandMessage>? Said;

    /// <summary>A window's dialogs: it is given the name of a command and answers whether it shows one for it. On the thread of the command; null where
    /// there is no window.</summary>
    public Func<string, bool>? Dialogs { get; set; }

    public DocumentSession Document { get; } = new();

    public MachineSession Machine { get; }

    /// <summary>The view and its switches.</summary>
    public ViewSession View { get; } = new();

    /// <summary>The settings that the desktop keeps between two starts.</summary>
    public SettingsSession Settings { get; }

    /// <summary>Strokes, job, findings and plan of the document.</summary>
    public DerivationSession Derivation { get; }

    /// <summary>How the job of the document stands to its certificate.</summary>
    public CertificateWatch Certificates { get; } = new();

    /// <summary>Every run and every program that was written.</summary>
    public JobHistory History { get; }

    /// <summary>Plays the planned motion of the document that was derived last.</summary>
    public PlaybackSession Playback { get; }

    /// <summary>How far AUTOSEQUENCE has walked.</summary>
    public SequenceWalk Walk { get; } = new();

    /// <summary>The progress of the command at work.</summary>
    public CommandProgress Progress { get; } = new();

    /// <summary>The steps of CNCCOMMISSION and where they stand.</summary>
    public CommissioningCourse Commissioning { get; } = new(() => CncCommissionCommand.StepNames);

    public CommandCatalog Catalog { get; }

    /// <summary>The command that Enter would repeat; null for none, and for one that starts motion.</summary>
    public string? Repeatable => _last is { Info: { StartsMotion: false } info } ? info.Name : null;

    /// <summary>The commands that run beside the one at work.</summary>
    public BesideCommands Beside { get; }

    /// <summary>What becomes of inputs that are typed while a command works.</summary>
    public TypedAhead Ahead { get; }

    public AliasTable Aliases { get; private set; }

    /// <summary>True while a command is at work and asks nothing.</summary>
    public bool IsBusy => Volatile.Read(ref _taking) != 0 || _frames.Top is { Pending: null };

    /// <summary>Name of the command that is at work or asks, the outer one; null while none runs.</summary>
    public string? Running => _frames.Outermost?.Info.Name;

    /// <summary>The command at work was told to end (Esc) and has not ended yet.</summary>
    public bool IsEnding => IsBusy && _frames.Outermost is { IsCancelled: true };

    /// <summary>What is waited for now.</summary>
    public PromptView Prompt
    {
        get
        {
            if (Beside.Asking is { Pending: { } question } beside) return View(beside, "", question.Prompt);
            return _frames.Top is { Pending: { } asks } frame ? View(frame, _frames.Before, asks.Prompt) : PromptView.Idle;

            PromptView View(CommandFrame frame, string before, Prompt asks) =>
                new(frame.Info.Name, before + asks.TextIn(Settings.Current.Figures()), asks.Options, asks.Default, asks.TakesSpaces, asks.Aim) { Preview = asks.Preview, File = asks.File, Replaces = asks.Replaces };
        }
    }

    /// <summary>What the operator sees lit up, indices into the drawing's entities: what was picked for the command that runs, else the selection.</summary>
    public IReadOnlyList<int> Lit => _frames.Picked ?? Document.Current.Selection;

    /// <summary>File names that are not rooted are looked for and written here.</summary>
    public string Folder => Environment.Folder;

    internal CommandEnvironment Environment { get; }

    /// <summary>A machine that is not simulated moves only after CNCARM, whoever starts it; a simulated one also when a script says so, and where the
    /// environment wants no arming.</summary>
    internal bool RunNeedsArming => !Machine.Connection.IsSimulation || (Environment.RunNeedsArming && !_scripts.IsRunnable);

    /// <summary>True when a script may not start the machine: at a desktop it may connect and arm, but a machine that is not simulated is started by a
    /// person.</summary>
    internal bool StartIsForHands => Environment.RunNeedsArming && _scripts.IsRunnable && !Machine.Connection.IsSimulation;

    /// <summary>True while inputs come from a script.</summary>
    internal bool IsScripted => _scripts.IsRunnable;

    /// <summary>The name of the command inside which another runs; null when none does.</summary>
    internal string? Outer => _frames.IsNested ? _frames.Outermost!.Info.Name : null;

    /// <summary>A job runs or something moves: no input is kept to be run after it.</summary>
    internal bool IsMachineAtWork => Machine.IsRunning || Machine.Status.State.IsMotion();

    internal bool OpensDialog(string command) => Dialogs?.Invoke(command) ?? false;

    /// <summary>Where a number alone is measured from, towards the cursor, when a place is asked for (direct distance entry), drawing units; null when it
    /// is no place, or one that stands alone.</summary>
    public Point2D? DistanceFrom => _frames.Top is { Pending.Prompt: PointPrompt { Use: PointUse.Place, From: { } from } } ? from : null;

    internal Point2D LastPoint { get; set; }

    internal ConcurrentDictionary<string, string> Memory { get; } = new(StringComparer.Ordinal);

    /// <summary>Takes one input, as typed up to Enter (or Space, where the prompt does not take spaces). Empty is Enter alone: the default, the end of a
    /// list, or the last command again.</summary>
    /// <param name="cancellation">The operator's stop: a job under way is ended, with the machine standing, before this returns.</param>
    public Task<InputResult> EnterAsync(string input, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(input);
        return EnterAsync(input.Trim(), input.Trim(), cancellation);
    }

    /// <summary>Takes a place that was pointed at, exactly; the history shows it as lengths are printed.</summary>
    /// <param name="cancellation">As for one input.</param>
    public Task<InputResult> PointAsync(Point2D place, CancellationToken cancellation) =>
        EnterAsync(string.Create(CultureInfo.InvariantCulture, $"{place.X:R},{place.Y:R}"), Settings.Current.Figures().Place(place), cancellation);

    private async Task<InputResult> EnterAsync(string input, string shown, CancellationToken cancellation)
    {
        Environment.Journal?.WriteLine(ScriptText.Write(input));
        if (Beside.Asks || Interlocked.Exchange(ref _taking, 1) != 0) return Told(await Beside.EnterAsync(input, cancellation, shown).ConfigureAwait(false));
        try
        {
            var result = await EnterOneAsync(input, cancellation, shown).ConfigureAwait(false);
            return Told(_scripts.IsRunnable ? await RunScriptsAsync(cancellation).ConfigureAwait(false) : result);
        }
        finally
        {
            Volatile.Write(ref _taking, 0);
        }
    }

    /// <summary>Begins a command inside the one that asks, as a key or a button does; typed, an apostrophe stands before it, which in an answer of text is
    /// a letter. With nothing asked it begins by itself.</summary>
    /// <param name="cancellation">As for one input.</param>
    public async Task<InputResult> EnterInsideAsync(string command, CancellationToken cancellation)
    {
        if (_frames.Top is not { Pending: not null } frame) return await EnterAsync(command, cancellation).ConfigureAwait(false);
        if (Interlocked.Exchange(ref _taking, 1) != 0) return Told(await Beside.EnterAsync(command, cancellation).ConfigureAwait(false));
        try
        {
            Environment.Journal?.WriteLine("'" + command);
            Echo("'" + command);
            return Told(await BeginInsideAsync(frame, command, cancellation).ConfigureAwait(false));
        }
        finally
        {
            Volatile.Write(ref _taking, 0);
        }
    }

    /// <summary>Takes several lines at once, as pasted text is: a script of them, under the rules for scripts. While a command is at work nothing of it is
    /// taken.</summary>
    /// <param name="cancellation">As for one input.</param>
    public async Task<InputResult> EnterLinesAsync(string lines, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(lines);
        if (IsBusy || Interlocked.Exchange(ref _taking, 1) != 0) return Told(new InputResult.NotUnderstood(Wording.Get("CommandSession.PasteWhileBusy")));
        try
        {
            Environment.Journal?.WriteLine(lines.TrimEnd());
            QueueScript(Wording.Get("CommandSession.PastedLines"), lines);
            return Told(await RunScriptsAsync(cancellation).ConfigureAwait(false));
        }
        finally
        {
            Volatile.Write(ref _taking, 0);
        }
    }

    /// <summary>Esc: ends what asks and clears the selection. A command at work is cancelled (a job stops the machine first); the caller that entered it
    /// gets the result.</summary>
    public async Task CancelAsync()
    {
        if (await Beside.EndAsync().ConfigureAwait(false)) return;
        if (IsBusy)
        {
            _scripts.Clear();
            _frames.Cancel();
            Say(MessageKind.Note, Wording.Get("CommandSession.Cancel"));
            return;
        }

        SnapOverride.End(this);
        await EndAllAsync().ConfigureAwait(false);
        Say(MessageKind.Note, Wording.Get("CommandSession.Cancel"));
        if (Document.Current.Selection.Count > 0) Document.Select([], Document.Current.Previous);
    }

    /// <summary>Commands whose name or alias begins with what is typed; an alias that is meant exactly comes first.</summary>
    public IReadOnlyList<CommandSuggestion> Suggest(string typed)
    {
        ArgumentNullException.ThrowIfNull(typed);
        return CommandNames.Suggest(typed, Catalog, Aliases);
    }

    public async ValueTask DisposeAsync()
    {
        await Beside.EndAsync().ConfigureAwait(false);
        await EndAllAsync().ConfigureAwait(false);
        _ties.Dispose();
        Derivation.Dispose();
        await Machine.DisposeAsync().ConfigureAwait(false);
    }

    internal void Say(MessageKind kind, string text) => Said?.Invoke(this, new CommandMessage(kind, text));

    /// <summary>Queues the inputs of a script. SCRIPT is no command to repeat then, or a blank line at the script's beginning would run it again.</summary>
    internal void QueueScript(string path, string text)
    {
        _scripts.Add(path, text);
        _last = null;
    }

    /// <summary>A path for the journal of a run that starts now.</summary>
    public string NewRunJournal(string drawing) => Machines.Runs.JournalFolder.NewJournal(drawing, Environment.RunJournalFolder, Environment.Time);

    internal string FileToRead(string name) => _scripts.FileToRead(Environment.Folder, name);

    internal AliasTable ReloadAliases() => Aliases = AliasFiles.Read(Environment.AliasFile, Catalog);

    private async Task<InputResult> EnterOneAsync(string input, CancellationToken cancellation, string? shown = null)
    {
        if (_frames.Top is { Pending: null }) return await Beside.EnterAsync(input, cancellation, shown).ConfigureAwait(false);
        Echo(shown ?? input);
        if (_frames.Top is not { } frame) return await BeginAsync(input, cancellation).ConfigureAwait(false);
        if (input.StartsWith('\'') && frame.Pending is not { Prompt.TakesSpaces: true }) return await BeginInsideAsync(frame, input, cancellation).ConfigureAwait(false);
        if (SnapOverride.Take(this, frame.Pending, input)) return new InputResult.Asking();
        if (frame.Answer(input, LastPoint) is { } wanted) return new InputResult.NotUnderstood(wanted);
        SnapOverride.End(this);
        return await SettleAsync(frame, cancellation).ConfigureAwait(false);
    }

    private async Task<InputResult> BeginAsync(string input, CancellationToken cancellation)
    {
        if (input.Length == 0) return await RepeatAsync(cancellation).ConfigureAwait(false);
        if (Find(input) is not { } command) return new InputResult.NotUnderstood(Wording.Get("CommandSession.UnknownCommand", input));
        _last = command.Info.IsRepeated ? command : null;
        return await StartAsync(command, cancellation, CommandWord.HasDash(input)).ConfigureAwait(false);
    }

    private async Task<InputResult> RepeatAsync(CancellationToken cancellation)
    {
        if (_last is not { } command) return new InputResult.Done();
        if (!command.Info.StartsMotion) return await StartAsync(command, cancellation).ConfigureAwait(false);
        Say(MessageKind.Note, Wording.Get("CommandSession.MotionNotRepeated", command.Info.Name));
        return new InputResult.Done();
    }

    private async Task<InputResult> BeginInsideAsync(CommandFrame outer, string input, CancellationToken cancellation)
    {
        if (Find(input) is not { } command) return new InputResult.NotUnderstood(Wording.Get("CommandSession.UnknownCommand", input));
        if (!command.Info.Transparent || _frames.IsNested) return new InputResult.NotUnderstood(Wording.Get("CommandSession.CannotRunInside", command.Info.Name, outer.Info.Name));
        return await StartAsync(command, cancellation, CommandWord.HasDash(input)).ConfigureAwait(false);
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
        var result = await _frames.SettledAsync(frame, cancellation).ConfigureAwait(false);
        if (result is not InputResult.Done || _frames.Top is not { } outer) return result;
        Say(MessageKind.Note, Wording.Get("CommandSession.ResumingCommand", outer.Info.Name));
        return new InputResult.Asking();
    }

    private Task EndAllAsync()
    {
        _scripts.Clear();
        return _frames.EndAllAsync();
    }

    private InputResult Told(InputResult result)
    {
        if (result is InputResult.Failed failed) Say(MessageKind.Error, failed.Sentence);
        if (result is InputResult.NotUnderstood unclear) Say(MessageKind.Error, unclear.Sentence);
        return result;
    }

    internal void Echo(string input)
    {
        if (SystemVariables.Variable(Settings.Current, "CMDECHO") != 0.0) Say(MessageKind.Echo, $"{Prompt.Text} {input}".TrimEnd());
    }

    internal ICommand? Find(string input) => CommandNames.Find(input, Catalog, Aliases);

    /// <summary>Enters what is queued, until a command fails or the inputs are used up.</summary>
    private async Task<InputResult> RunScriptsAsync(CancellationToken cancellation)
    {
        InputResult result = new InputResult.Done();
        while (_scripts.Next() is { } next)
        {
            result = cancellation.IsCancellationRequested ? new InputResult.Cancelled() : await EnterOneAsync(next.Token.Text, cancellation).ConfigureAwait(false);
            if (result is InputResult.Asking or InputResult.Done) continue;
            await EndAllAsync().ConfigureAwait(false);
            return next.Placed(result);
        }

        return result;
    }
}

/// <summary>What the command window shows before the cursor.</summary>
/// <param name="Command">Name of the command that asks; null when a command is awaited.</param>
/// <param name="Text">The whole line, <c>&gt;&gt;</c> before it inside a transparent command.</param>
/// <param name="Options">To be clicked or completed.</param>
/// <param name="Default">What Enter alone means; null when nothing.</param>
/// <param name="TakesSpaces">True when Space is a letter and not Enter.</param>
/// <param name="Aim">The place that a click on the canvas answers with (its coordinates are entered); null when it is no answer.</param>
public sealed record PromptView(string? Command, string Text, IReadOnlyList<Keyword> Options, string? Default, bool TakesSpaces, PointAim? Aim)
{
    /// <summary>What Enter alone would lead to (<see cref="CommandLanguage.Prompt.Preview"/>); null when there is nothing to be seen.</summary>
    public GhostOf? Preview { get; init; }

    /// <summary>The files that fit, where the name of one is asked for; null where none is.</summary>
    public FileWanted? File { get; init; }

    /// <summary>The question whether a file is replaced.</summary>
    public bool Replaces { get; init; }

    public static PromptView Idle => new(null, Wording.Get("Prompt.Command"), [], null, false, null);
}
