using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Commands;
using Engraver.Workbench.LetteredDrawings;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Views;

namespace Engraver.App.Desk;

/// <summary>Connects the window with the command session: inputs go to it through <see cref="Queue"/>, its events come back through
/// <see cref="Notifications"/>. Decides nothing.</summary>
/// <remarks>All members are for the UI thread, <see cref="StopNow"/> and <see cref="HoldNow"/> for any.</remarks>
public sealed class DesktopModel : IAsyncDisposable
{
    /// <summary>A finding is shown with this many times its size around it.</summary>
    private const double FindingMargin = 4.0;

    /// <summary>... and never nearer than this part of the drawing.</summary>
    private const double MinPart = 0.02;

    private readonly MemoryReclaimer _memory;

    public DesktopModel(CommandSession session, TimeProvider time)
    {
        (Session, Time) = (session, time);
        Derived = new DerivedModel(session);
        _memory = MemoryReclaimer.ForDesktop(() => IsMoving);
        Notifications = new DesktopNotifications(session, Derived, _memory);
        Queue = new CommandQueue(session, Notifications);
        session.Derivation.IsAutomatic = true;
    }

    public CommandSession Session { get; }

    public TimeProvider Time { get; }

    /// <summary>Inputs on their way to the session.</summary>
    public CommandQueue Queue { get; }

    /// <summary>What the session reports.</summary>
    public DesktopNotifications Notifications { get; }

    /// <summary>What follows from the document.</summary>
    public DerivedModel Derived { get; }

    /// <summary>The prompt, as of the last notification.</summary>
    public PromptView Prompt => Notifications.Prompt;

    /// <summary>The point of the drawing that a click would give now; null while the cursor is not on the canvas.</summary>
    public Point2D? Cursor { get; set; }

    /// <summary>The line that is typed and not yet entered.</summary>
    public string TypedLine
    {
        get;
        set
        {
            if (field == value) return;
            field = value;
            TypedLineChanged?.Invoke();
        }
    } = "";

    /// <summary>Another line is typed.</summary>
    public event Action? TypedLineChanged;

    /// <summary>True while a job runs or anything of the machine moves.</summary>
    public bool IsMoving => Moves(Session.Machine);

    /// <summary>The memory of every large drawing that is gone has been returned to the computer.</summary>
    internal bool IsMemoryReclaimed => _memory.IsDone;

    /// <summary>True while a job runs or anything moves; from any thread.</summary>
    public static bool Moves(MachineSession machine) => machine.IsRunning || machine.Status.State.IsMotion();

    /// <summary>Waits until every input has run and what follows from the document is computed and delivered.</summary>
    public async Task SettleAsync()
    {
        await Queue.Idle;
        try
        {
            if (!Session.Derivation.IsCancelled) await Session.Derivation.ForCurrentAsync(Queue.Closing);
        }
        catch (OperationCanceledException)
        {
            // the document changed meanwhile; its derivation is announced when it is there
        }

        Notifications.Deliver();
        await Derived.Written.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing | ConfigureAwaitOptions.ContinueOnCapturedContext);
        Notifications.Deliver();
    }

    /// <summary>START: runs what is armed.</summary>
    public Task<InputResult> StartArmedAsync() => Queue.RunAsync("CNCRUN");

    /// <summary>Selects without a command, as a click on the canvas does: what is found is added, or taken out.</summary>
    public Task SelectAsync(Func<Drawing, IReadOnlyList<int>> find, bool remove) => Queue.PerformAsync(() => SelectNow(find, remove));

    /// <summary>Brings the place of a finding into the middle of the canvas, near enough to see it.</summary>
    public void ShowPlaceOf(Diagnostic finding)
    {
        if (Session.Document.Current.Drawing is not { } drawing) return;
        if (finding.Place is { } place)
        {
            var whole = Session.View.ExtentsOf(drawing);
            var part = MinPart * Math.Max(whole.Width, whole.Height);
            Session.View.FocusOn(new ViewFocus(drawing.Scale.ToDrawing(place), finding), part > 0.0 ? part : null);
            return;
        }

        var shown = ShownDrawing.Of(drawing);
        if (finding.Source.Handle is not { } handle || shown.IndexOfHandle(handle) is not { } entity) return;
        var box = DrawingExtents.Measure(shown, [entity]);
        if (box.IsEmpty) return;
        var everything = Session.View.ExtentsOf(drawing);
        var height = Math.Max(FindingMargin * Math.Max(box.Width, box.Height), MinPart * Math.Max(everything.Width, everything.Height));
        Session.View.FocusOn(new ViewFocus(new Point2D((box.MinX + box.MaxX) / 2.0, (box.MinY + box.MaxY) / 2.0), finding), height > 0.0 ? height : null);
    }

    /// <summary>The operator's stop. Straight to the machine, from any thread; waits for nothing.</summary>
    public void StopNow()
    {
        Session.Machine.Controls.Stop();
        Session.TypeAhead.Flush();
    }

    /// <summary>Holds the job under way. From any thread; waits for nothing.</summary>
    public void HoldNow() => Session.Machine.Controls.HoldJob();

    /// <summary>Changes the operator's feed by a part of the programmed one.</summary>
    public void OverrideBy(double part) => Session.Machine.Controls.Override(Math.Round(Session.Machine.Status.FeedRatio + part, 2), null);

    /// <summary>The same for rapids.</summary>
    public void OverrideRapidsBy(double part) => Session.Machine.Controls.Override(null, Math.Round(Session.Machine.Status.RapidRatio + part, 2));

    public async ValueTask DisposeAsync()
    {
        Notifications.Dispose();
        await Queue.DisposeAsync().ConfigureAwait(false);
        await Session.DisposeAsync().ConfigureAwait(false);
    }

    private InputResult.Done SelectNow(Func<Drawing, IReadOnlyList<int>> find, bool remove)
    {
        var state = Session.Document.Current;
        if (state.Drawing is not { } drawing || Session.Prompt.Command is not null) return new InputResult.Done();
        var found = find(drawing);
        Session.Document.SelectIn(drawing, now =>
        {
            var known = (remove ? found : now.Selection).ToHashSet();
            return remove ? [.. now.Selection.Where(entity => !known.Contains(entity))] : [.. now.Selection, .. found.Where(entity => !known.Contains(entity))];
        });
        return new InputResult.Done();
    }
}
