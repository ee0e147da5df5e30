using Engraver.App.Canvas;
using Engraver.App.Canvas.Overlays;
using Engraver.App.Canvas.Scenes;
using Engraver.Core.Drawings;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Documents;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Sidecars;

namespace Engraver.App.Desk;

/// <summary>Supplies the canvas with its content: drawing and job prepared in the background; selection, playback, machine and progress as they change. UI
/// thread only.</summary>
public sealed class CanvasSource
{
    private readonly DesktopModel _desk;
    private readonly DrawingCanvas _canvas;
    private Drawing? _drawing;
    private PlateValues _values = PlateValues.None;
    private PreparedJob? _job;
    private MachineOverlay? _machine;
    private TrajectoryList _trajectories = TrajectoryList.Empty;
    private readonly FirstPictureGate _firstPicture;

    public CanvasSource(DesktopModel desk, DrawingCanvas canvas)
    {
        (_desk, _canvas) = (desk, canvas);
        canvas.View = desk.Session.View;
        _firstPicture = new FirstPictureGate(desk.Time);
        desk.Session.Derivation.Prerequisite = state => _firstPicture.WhenShown(state.Drawing);
        canvas.PictureDrawn += () => _firstPicture.OnShown(canvas.HasPictureOfScene ? canvas.Scene?.Drawing : null);
        desk.Notifications.Changed += Refresh;
        desk.Derived.ToolMoved += ShowTool;
        desk.TypedLineChanged += canvas.Pointing.UpdatePointRequest;
        Refresh();
    }

    /// <summary>Completes when the current drawing and job are shown.</summary>
    public Task Shown { get; private set; } = Task.CompletedTask;

    /// <summary>The canvas shows the current document and its derivation; false while a change has not yet reached the window.</summary>
    public bool IsCurrent => Shown.IsCompleted && ReferenceEquals(_desk.Session.Document.Current.Drawing, _drawing) && ReferenceEquals(_desk.Derived.Job, _job);

    private void Refresh()
    {
        var state = _desk.Session.Document.Current;
        var values = _desk.Session.Plates.Of(state)?.Values ?? PlateValues.None;
        if (!ReferenceEquals(state.Drawing, _drawing) || values != _values) Shown = Task.WhenAll(Shown, ShowDrawingAsync(_drawing = state.Drawing, _values = values));
        if (!ReferenceEquals(_desk.Derived.Job, _job)) Shown = Task.WhenAll(Shown, ShowJobAsync(_job = _desk.Derived.Job));
        var lit = _desk.Session.HighlightedEntities;
        if (!ReferenceEquals(_canvas.Selection, lit)) _canvas.Selection = lit;
        _canvas.ShowsGrips = ReferenceEquals(lit, state.Selection) && _desk.Prompt.Command is null or CanvasCommands.GripEdit;
        ShowTrajectories(state.Sidecar.Trajectories);
        ShowMachine();
        ApplyVariables(_desk.Session.Settings.Current);
        _canvas.Pointing.UpdatePointRequest();
        ShowTool();
    }

    private void ApplyVariables(DesktopSettings settings)
    {
        (_canvas.CursorSize, _canvas.Pointing.PickBox, _canvas.Pointing.Aids.Aperture) = (settings.Variable("CURSORSIZE"), settings.Variable("PICKBOX"), settings.Variable("APERTURE"));
        (_canvas.Pointing.ZoomFactor, _canvas.Pointing.ReversesWheel) = (settings.Variable("ZOOMFACTOR"), settings.Variable("ZOOMWHEEL") != 0.0);
        _canvas.Pointing.Figures = settings.Figures();
    }

    private async Task ShowDrawingAsync(Drawing? drawing, PlateValues values)
    {
        var scene = drawing is null ? null : await Task.Run(() => CanvasScene.From(drawing));
        if (!ReferenceEquals(drawing, _drawing) || values != _values) return;
        _canvas.Overlay = null;
        _canvas.Scene = scene;
        _canvas.Overlay = WithTrajectories(null);
        ShowTool();
        if (_job is { } job && ReferenceEquals(job.DocumentDrawing, drawing)) await ShowJobAsync(job);
    }

    private async Task ShowJobAsync(PreparedJob? job)
    {
        var derived = _desk.Derived.Current;
        var machine = _machine = MachineOverlay.Of(job, _desk.Session.Machine, _desk.Session.Settings.Current.TraceColour());
        var overlay = job is null ? null : await Task.Run(() => OverlayScene.From(job, machine.ApplyTo(OverlayInputBuilder.From(derived))));
        if (ReferenceEquals(job, _job)) _canvas.Overlay = WithTrajectories(overlay);
    }

    private void ShowTrajectories(TrajectoryList list)
    {
        if (ReferenceEquals(list.All, _trajectories.All)) return;
        _trajectories = list;
        _canvas.Overlay = WithTrajectories(_canvas.Overlay);
    }

    private OverlayScene? WithTrajectories(OverlayScene? overlay)
    {
        if (_drawing is null || (_trajectories.All.Count == 0 && overlay is null)) return overlay;
        return (overlay ?? OverlayScene.Empty).WithTrajectories(_trajectories.All, _drawing.Scale);
    }

    /// <summary>Updates the machine overlay after a change of the origin, the recorded run or its colour.</summary>
    private void ShowMachine()
    {
        var now = MachineOverlay.Of(_job, _desk.Session.Machine, _desk.Session.Settings.Current.TraceColour());
        if (now == _machine || _canvas.Overlay is not { } overlay || !Shown.IsCompleted) return;
        _machine = now;
        _canvas.Overlay = overlay.WithMachine(now.ApplyTo(OverlayInputs.None));
    }

    /// <summary>Shows the position of the machine, always, and of the playback, while it is in use.</summary>
    private void ShowTool()
    {
        var (status, state) = (_desk.Session.Machine.Status, _desk.Session.Document.Current);
        _canvas.Machine = MachineMarkBuilder.Of(_desk.Session.Machine, state);
        var isOfScene = ReferenceEquals(_desk.Derived.Current.State.Drawing, _canvas.Scene?.Drawing); // the plan of an earlier drawing refers to other entities and points
        var moment = _desk.Session.Playback.IsShown && isOfScene ? _desk.Derived.Moment : null;
        _canvas.PlaybackPosition = moment?.Position is { } at ? state.Scale.ToDrawing(at) : null;
        _canvas.Highlight = moment?.Entity is >= 0 and var entity ? entity : null;
        _canvas.EngravedMoves = _desk.Session.SequenceAnimation.Moves ?? MovesDone((status.IsDryRun ? 0 : status.Progress?.SegmentsDone) ?? _desk.Session.Machine.Runs.Part?.Shown.Segments ?? 0);
    }

    /// <summary>Number of moves of the job's toolpath that are cut; a segment of the controller is a move or a part of one.</summary>
    private int MovesDone(int segmentsDone)
    {
        if (segmentsDone == 0 || _desk.Session.Machine.Runs.ShownJob?.Trajectories is not null) return 0; // trajectories are not moves of the toolpath
        if (_desk.Derived.Current.Motion is not { } motion || _canvas.Overlay is not { } overlay) return 0;
        return segmentsDone >= motion.SegmentCount ? overlay.MoveCount : motion.At(motion.TimeOfSegment(segmentsDone)).Move;
    }
}
