using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Alarms;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Playback;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Views;

namespace Engraver.Workbench.Commands;

/// <summary>What a running command works with: the document, the machine, and the operator whom it asks and tells.</summary>
public sealed class CommandContext
{
    private readonly CommandSession _session;
    private readonly CommandFrame _frame;

    internal CommandContext(CommandSession session, CommandFrame frame) => (_session, _frame) = (session, frame);

    public DocumentSession Document => _session.Document;

    public MachineSession Machine => _session.Machine;

    public ViewSession View => _session.View;

    public SettingsSession Settings => _session.Settings;

    public DerivationSession Derivation => _session.Derivation;

    public PlaybackSession Playback => _session.Playback;

    /// <summary>Where AUTOSEQUENCE shows how far it has walked.</summary>
    internal SequenceWalk Walk => _session.Walk;

    /// <summary>A person sits at a desktop and has typed or clicked the command.</summary>
    internal bool IsWatched => _session.Environment.RunNeedsArming && !IsScripted;

    /// <summary>Every run and every program that was written.</summary>
    public JobHistory History => _session.History;

    /// <summary>How the job of the document stands to its certificate.</summary>
    public CertificateWatch Certificates => _session.Certificates;

    /// <summary>Where a long command reports its progress.</summary>
    public CommandProgress Progress => _session.Progress;

    /// <summary>Where CNCCOMMISSION tells which step it is at.</summary>
    internal CommissioningCourse Commissioning => _session.Commissioning;

    public CommandCatalog Catalog => _session.Catalog;

    public AliasTable Aliases => _session.Aliases;

    public TimeProvider Time => _session.Environment.Time;

    /// <summary>The open drawing.</summary>
    /// <exception cref="CommandException">None is open.</exception>
    public Drawing Drawing => Document.Current.Drawing ?? throw new CommandException(CommandFailure.Usage, Wording.Get("CommandContext.NoDrawingOpen"));

    /// <summary>What <c>@</c> is relative to, drawing units.</summary>
    public Point2D LastPoint
    {
        get => _session.LastPoint;
        internal set => _session.LastPoint = value;
    }

    /// <summary>Asks the operator.</summary>
    /// <exception cref="OperationCanceledException">Esc.</exception>
    public async Task<Answer<T>> AskAsync<T>(ValuePrompt<T> prompt)
    {
        var answer = await _frame.AskAsync(prompt).ConfigureAwait(false);
        if (answer is Answer<Point2D>.Value point) _session.LastPoint = point.Of;
        else if (answer is Answer<Amount>.Value { Of: Amount.Beginning beginning }) _session.LastPoint = beginning.At;
        return answer;
    }

    /// <summary>Asks for a value; the prompt must have neither options nor an end.</summary>
    public async Task<T> ValueAsync<T>(ValuePrompt<T> prompt) => ((Answer<T>.Value)await AskAsync(prompt).ConfigureAwait(false)).Of;

    /// <summary>Asks for one of several options.</summary>
    public async Task<string> ChoiceAsync(string instruction, IReadOnlyList<Keyword> options, string? standard) =>
        ((Answer<string>.Chosen)await AskAsync(new ChoicePrompt(instruction) { Options = options, Default = standard }).ConfigureAwait(false)).Option;

    /// <summary>Asks a question whose Enter means no.</summary>
    public async Task<bool> ConfirmAsync(string question) => await ChoiceAsync(question, Keyword.List("Yes", "No"), "No").ConfigureAwait(false) == "Yes";

    /// <summary>Asks whether a file that is there already is replaced; Enter means no.</summary>
    /// <exception cref="CommandException">It is not to be.</exception>
    public async Task ConfirmReplaceAsync(string name, string question)
    {
        var prompt = new ChoicePrompt(question) { Options = Keyword.List("Yes", "No"), Default = "No", Replaces = true };
        if (await AskAsync(prompt).ConfigureAwait(false) is not Answer<string>.Chosen { Option: "Yes" }) throw new CommandException(CommandFailure.Usage, Wording.Get("ResultFile.NotReplaced", name));
    }

    public void Say(string text, MessageKind kind = MessageKind.Note) => _session.Say(kind, text);

    /// <summary>Says a result of several lines, as a stage writes it.</summary>
    public void SayResult(Action<TextWriter> write)
    {
        using var text = new StringWriter { NewLine = "\n" };
        write(text);
        Say(text.ToString().TrimEnd('\n'), MessageKind.Result);
    }

    /// <summary>Takes a document step under the command's own name.</summary>
    /// <exception cref="OperationCanceledException">Esc came while the command was at work: nothing is changed.</exception>
    /// <exception cref="CommandException">The command runs beside another one, which may need the document as it is.</exception>
    public void Take(DocumentState next)
    {
        BeforeStep();
        Document.Take(_frame.Info.Name, next);
    }

    /// <summary>Changes the document within the step that this command took before, so that undoing goes back behind both.</summary>
    /// <exception cref="OperationCanceledException">Esc came while the command was at work: nothing is changed.</exception>
    /// <exception cref="CommandException">The command runs beside another one, which may need the document as it is.</exception>
    public void Amend(DocumentState next)
    {
        BeforeStep();
        Document.Amend(next);
    }

    /// <summary>Lights up what was picked for this command, until it ends or takes a step.</summary>
    /// <param name="picked">Indices into the drawing's entities; null: nothing is picked any more.</param>
    public void ShowPicked(IReadOnlyList<int>? picked) => _frame.Picked = picked;

    /// <summary>How lengths and angles are printed (LUPREC, AUPREC).</summary>
    public Figures Figures => Settings.Current.Figures();

    private void BeforeStep()
    {
        if (_frame.IsCancelled) throw new OperationCanceledException();
        RefuseBeside();
        _frame.Picked = null; // its indices are those of the drawing before
    }

    /// <summary>For the part of a command that changes the document, where another part of it only looks and is heard while another command is at
    /// work.</summary>
    /// <exception cref="CommandException">Another command is at work.</exception>
    internal void RefuseBeside()
    {
        if (_frame.IsBeside) throw new CommandException(CommandFailure.Usage, Wording.Get("CommandSession.DrawingInUse", _frame.Info.Name, _session.Running ?? Wording.Get("CommandSession.AnotherCommand")));
    }

    /// <summary>Asks a window to show its dialog instead of asking at the command line: not for a script, and not when a dash was typed before the
    /// name.</summary>
    /// <returns>False when there is no such window.</returns>
    internal bool OpensDialog() => !_frame.HasNoDialog && !IsScripted && _session.OpensDialog(_frame.Info.Name);

    /// <summary>The value that was used last at a prompt of this name, or a first one.</summary>
    public string Remembered(string prompt, string first) => _session.Memory.GetValueOrDefault(prompt, first);

    /// <summary>The value that was used last at a prompt of this name; null when there is none yet.</summary>
    public string? Remembered(string prompt) => _session.Memory.GetValueOrDefault(prompt);

    public void Remember(string prompt, string value) => _session.Memory[prompt] = value;

    /// <summary>A file to read: in the working folder, else beside the script that runs.</summary>
    public string FileToRead(string name) => _session.FileToRead(name);

    /// <summary>The path of a result that is called as the drawing is, beside it; null while none is open.</summary>
    public string? BesideDrawing(string ending) => Document.FilePath is { } drawing ? Path.ChangeExtension(Path.GetFullPath(FileToWrite(drawing)), ending) : null;

    /// <summary>A file to write, in the working folder.</summary>
    public string FileToWrite(string name) => Path.Combine(_session.Environment.Folder, name);

    /// <summary>Puts the inputs of a script before everything that is queued.</summary>
    /// <exception cref="CommandException">Scripts call each other more than 16 levels deep.</exception>
    public void QueueScript(string path, string text) => _session.QueueScript(path, text);

    /// <summary>Where journals are for which nobody names a folder; null for the usual one.</summary>
    internal string? RunJournalFolder => _session.Environment.RunJournalFolder;

    internal double SimulatorSpeed => _session.Environment.SimulatorSpeed;

    /// <summary>A text whose settings and commands are named in the words of where it is read; what an operator typed is put in afterwards.</summary>
    internal string Spell(string text) => _session.Environment.Speech(text);

    internal string CommissionedProfile => _session.Environment.CommissionedProfile;

    internal bool RunNeedsArming => _session.RunNeedsArming;

    internal bool StartIsForHands => _session.StartIsForHands;

    internal bool IsScripted => _session.IsScripted;

    /// <summary>The name of the command inside which this one runs; null when it runs by itself.</summary>
    internal string? Outer => _session.Outer;

    /// <summary>Adds a job to the history; that it cannot be kept is said.</summary>
    internal void Remember(HistoryEntry entry)
    {
        if (History.Add(entry).Failure is { } failure) SayNotKept(failure);
    }

    /// <summary>A run that begins is in the history from now on.</summary>
    internal OpenJob Begin(HistoryEntry entry) => new(History, entry, SayNotKept);

    private void SayNotKept(string failure) => Say(Wording.Get("History.NotKept", failure), MessageKind.Warning);

    /// <summary>A path for the journal of a run that starts now.</summary>
    internal string NewRunJournal(string drawing) => _session.NewRunJournal(drawing);

    /// <summary>Ends a command that threw what nothing expects, a bug: a job under way is stopped, and an alarm says what happened.</summary>
    internal InputResult Broken(Exception bug)
    {
        var name = _frame.Info.Name;
        var wasRunning = Machine.IsRunning;
        if (wasRunning) Machine.Controls.Stop();
        var sentence = Wording.Get(wasRunning ? "CommandContext.InternalErrorJobStopped" : "CommandContext.InternalError", name, bug.GetType().Name, bug.Message);
        var report = _session.Environment.Failures?.Write(bug);
        Machine.Alarms.Raise(AlarmCause.InternalError, sentence, name, report is null ? Wording.Get("CommandContext.ReportErrorWithHistory") : Wording.Get("CommandContext.ReportError", report));
        Say(bug.ToString());
        return new InputResult.Failed(CommandFailure.Internal, sentence) { Bug = bug };
    }

    /// <summary>Reads the alias files anew.</summary>
    public AliasTable ReloadAliases() => _session.ReloadAliases();
}

/// <summary>A line of the command window's history.</summary>
public sealed record CommandMessage(MessageKind Kind, string Text);

public enum MessageKind
{
    /// <summary>A prompt and what was typed to it.</summary>
    Echo,

    /// <summary>What a command was asked for: figures, lists, program text.</summary>
    Result,

    /// <summary>What a command says without being asked.</summary>
    Note,

    Warning,

    /// <summary>A finding of severity error, or an input that was not understood.</summary>
    Error,
}
