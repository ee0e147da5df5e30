using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Motion;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Alarms;
using Engraver.Workbench.Playback;
using Engraver.Workbench.Plots;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Views;

namespace Engraver.Workbench.Commands;

/// <summary>The services of a running command: document, machine, prompts and messages.</summary>
public sealed class CommandContext
{
    private readonly CommandSession _session;
    private readonly CommandFrame _frame;

    internal CommandContext(CommandSession session, CommandFrame frame) => (_session, _frame) = (session, frame);

    public DocumentSession Document => _session.Document;

    public MachineSession Machine => _session.Machine;

    /// <summary>The controller families that machine profiles may name and addresses may reach.</summary>
    public MachineFamilies Families => _session.Families;

    /// <summary>The driver of the document's machine profile.</summary>
    public IMachineDriver Driver => MachineFamilies.DriverOf(Document.Current.Settings.Machine);

    public ViewSession View => _session.View;

    public SettingsSession Settings => _session.Settings;

    /// <summary>The plates of the open drawing.</summary>
    public PlateSession Plates => _session.Plates;

    /// <summary>What the fields in its texts stand for on the next plate.</summary>
    internal PlateValues PlateValues => Plates.Of(Document.Current)?.Values ?? PlateValues.None;

    public DerivationSession Derivation => _session.Derivation;

    public PlaybackSession Playback => _session.Playback;

    public PlotSession Plots => _session.Plots;

    /// <summary>Draws plots into pictures; null where the front end has no graphics library.</summary>
    internal IPlotRenderer? PlotRenderer => _session.Environment.PlotRenderer;

    /// <summary>Progress of the AUTOSEQUENCE animation.</summary>
    internal SequenceAnimation SequenceAnimation => _session.SequenceAnimation;

    /// <summary>True when an operator entered the command at the desktop.</summary>
    internal bool IsInteractive => _session.Environment.RunNeedsArming && !IsScripted;

    /// <summary>The history of runs and posted programs.</summary>
    public JobHistory History => _session.History;

    /// <summary>The certificate status of the document's job.</summary>
    public CertificateMonitor Certificates => _session.Certificates;

    /// <summary>Progress of a long command.</summary>
    public CommandProgress Progress => _session.Progress;

    /// <summary>The current step of CNCCOMMISSION.</summary>
    internal CommissioningProgress Commissioning => _session.Commissioning;

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
        if (answer is Answer<Point2D>.Value point) _session.LastPoint = point.Result;
        else if (answer is Answer<Amount>.Value { Result: Amount.FirstPoint beginning }) _session.LastPoint = beginning.Point;
        return answer;
    }

    /// <summary>Asks for a value; the prompt must have no options and no empty answer.</summary>
    public async Task<T> ValueAsync<T>(ValuePrompt<T> prompt) => ((Answer<T>.Value)await AskAsync(prompt).ConfigureAwait(false)).Result;

    /// <summary>Asks for one of several options.</summary>
    public async Task<string> ChoiceAsync(string instruction, IReadOnlyList<Keyword> options, string? standard) =>
        ((Answer<string>.SelectedOption)await AskAsync(new ChoicePrompt(instruction) { Options = options, Default = standard }).ConfigureAwait(false)).Option;

    /// <summary>Asks a question whose Enter means no.</summary>
    public async Task<bool> ConfirmAsync(string question) => await ChoiceAsync(question, Keyword.List("Yes", "No"), "No").ConfigureAwait(false) == "Yes";

    /// <summary>Asks whether an existing file is replaced; Enter means no.</summary>
    /// <exception cref="CommandException">The operator declined.</exception>
    public async Task ConfirmReplaceAsync(string name, string question)
    {
        var prompt = new ChoicePrompt(question) { Options = Keyword.List("Yes", "No"), Default = "No", ConfirmsReplacing = true };
        if (await AskAsync(prompt).ConfigureAwait(false) is not Answer<string>.SelectedOption { Option: "Yes" }) throw new CommandException(CommandFailure.Usage, Wording.Get("ResultFile.NotReplaced", name));
    }

    public void WriteMessage(string text, MessageKind kind = MessageKind.Note) => _session.WriteMessage(kind, text);

    /// <summary>Writes a result of several lines.</summary>
    public void WriteResult(Action<TextWriter> write)
    {
        using var text = new StringWriter { NewLine = "\n" };
        write(text);
        WriteMessage(text.ToString().TrimEnd('\n'), MessageKind.Result);
    }

    /// <summary>Commits an undo step under the command's name.</summary>
    /// <exception cref="OperationCanceledException">Esc was pressed while the command was running: nothing is changed.</exception>
    /// <exception cref="CommandException">The command runs concurrently with another one that may use the document.</exception>
    public void Commit(DocumentState next)
    {
        BeforeStep();
        Document.Commit(_frame.Info.Name, next);
    }

    /// <summary>Changes the document within the last step of this command, so that undo reverts both.</summary>
    /// <exception cref="OperationCanceledException">Esc was pressed while the command was running: nothing is changed.</exception>
    /// <exception cref="CommandException">The command runs concurrently with another one that may use the document.</exception>
    public void Amend(DocumentState next)
    {
        BeforeStep();
        Document.Amend(next);
    }

    /// <summary>Highlights the objects picked for this command, until it ends or commits a step.</summary>
    /// <param name="picked">Indices into the drawing's entities; null for none.</param>
    public void HighlightPicked(IReadOnlyList<int>? picked) => _frame.Picked = picked;

    /// <summary>Display precision of lengths and angles (LUPREC, AUPREC).</summary>
    public DisplayPrecision Precision => Settings.Current.Figures();

    private void BeforeStep()
    {
        if (_frame.IsCancelled) throw new OperationCanceledException();
        ThrowIfConcurrent();
        _frame.Picked = null; // Its indices refer to the previous drawing.
    }

    /// <summary>Called before the document is changed by a command of which another part may run concurrently with a running command.</summary>
    /// <exception cref="CommandException">Another command is running.</exception>
    internal void ThrowIfConcurrent()
    {
        if (_frame.IsConcurrent) throw new CommandException(CommandFailure.Usage, Wording.Get("CommandSession.DrawingInUse", _frame.Info.Name, _session.RunningCommand ?? Wording.Get("CommandSession.AnotherCommand")));
    }

    /// <summary>Opens the dialog of the command instead of prompting, except for scripts and for names typed with a dash.</summary>
    /// <returns>False if there is no dialog.</returns>
    internal bool TryOpenDialog() => !_frame.SuppressesDialogs && !IsScripted && _session.TryOpenDialog(_frame.Info.Name);

    /// <summary>The last value at a prompt of this name, or the initial one.</summary>
    public string LastValue(string prompt, string first) => _session.LastValues.GetValueOrDefault(prompt, first);

    /// <summary>The last value at a prompt of this name; null if there is none.</summary>
    public string? LastValue(string prompt) => _session.LastValues.GetValueOrDefault(prompt);

    public void Remember(string prompt, string value) => _session.LastValues[prompt] = value;

    /// <summary>Path of a file to read: in the working folder, otherwise beside the running script.</summary>
    public string ResolveInputPath(string name) => _session.ResolveInputPath(name);

    /// <summary>Path of a result beside the drawing, with the drawing's name; null if none is open.</summary>
    public string? PathBesideDrawing(string ending) => Document.FilePath is { } drawing ? Path.ChangeExtension(Path.GetFullPath(ResolveOutputPath(drawing)), ending) : null;

    /// <summary>Path of a file to write, in the working folder.</summary>
    public string ResolveOutputPath(string name) => Path.Combine(_session.Environment.Folder, name);

    /// <summary>Inserts the inputs of a script before all queued inputs.</summary>
    /// <exception cref="CommandException">Scripts are nested more than 16 levels deep.</exception>
    public void QueueScript(string path, string text) => _session.QueueScript(path, text);

    /// <summary>Folder of journals without an explicit path; null for the default.</summary>
    internal string? RunJournalFolder => _session.Environment.RunJournalFolder;

    internal double SimulatorSpeed => _session.Environment.SimulatorSpeed;

    /// <summary>Names the settings and commands of a text as the current front end does; text typed by the operator must be inserted afterwards.</summary>
    internal string ApplyTerminology(string text) => _session.Environment.Terminology(text);

    internal string CommissionedProfile => _session.Environment.CommissionedProfile;

    internal bool RunNeedsArming => _session.RunNeedsArming;

    internal bool RequiresManualStart => _session.RequiresManualStart;

    internal bool IsScripted => _session.IsScripted;

    /// <summary>Name of the enclosing command; null if this one is not nested.</summary>
    internal string? OuterCommand => _session.OuterCommand;

    /// <summary>Adds a job to the history; reports a write failure.</summary>
    internal void Remember(HistoryEntry entry)
    {
        if (History.Add(entry).Failure is { } failure) WarnNotSaved(failure);
    }

    /// <summary>Adds a run that starts to the history.</summary>
    internal PendingRun BeginRun(HistoryEntry entry) => new(History, entry, WarnNotSaved);

    private void WarnNotSaved(string failure) => WriteMessage(Wording.Get("History.NotKept", failure), MessageKind.Warning);

    /// <summary>A path for the journal of a run that starts now.</summary>
    internal string NewRunJournal(string drawing) => _session.NewRunJournal(drawing);

    /// <summary>Ends a command that threw an unexpected exception: stops a running job and raises an alarm.</summary>
    internal InputResult HandleInternalError(Exception bug)
    {
        var name = _frame.Info.Name;
        var wasRunning = Machine.IsRunning;
        if (wasRunning) Machine.Controls.Stop();
        var sentence = Wording.Get(wasRunning ? "CommandContext.InternalErrorJobStopped" : "CommandContext.InternalError", name, bug.GetType().Name, bug.Message);
        var report = _session.Environment.Failures?.Write(bug);
        Machine.Alarms.Raise(AlarmCause.InternalError, sentence, name, report is null ? Wording.Get("CommandContext.ReportErrorWithHistory") : Wording.Get("CommandContext.ReportError", report));
        WriteMessage(bug.ToString());
        return new InputResult.Failed(CommandFailure.Internal, sentence) { Exception = bug };
    }

    /// <summary>Reads the alias files again.</summary>
    public AliasTable ReloadAliases() => _session.ReloadAliases();
}
