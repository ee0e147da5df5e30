using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Commands.Editing;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Objects;

namespace Engraver.Workbench.Commands.Grips;

/// <summary>Objects dragged by a grip: the preview of an edit, and the committed edits as one undo step. The selection is kept.</summary>
internal sealed class GripDrag
{
    private readonly CommandContext _context;
    private readonly IReadOnlyList<int> _selected;
    private readonly IReadOnlyList<Grip> _hotGrips;
    private readonly SelectionGhost _ghost;
    private readonly UndoGroup _steps;
    private readonly Drawing _drawing;

    /// <param name="context">Context of the command.</param>
    /// <param name="selected">The selected objects.</param>
    /// <param name="hot">The dragged grips, all at one point.</param>
    public GripDrag(CommandContext context, IReadOnlyList<int> selected, IReadOnlyList<Grip> hot)
    {
        (_context, _selected, _hotGrips, _drawing) = (context, selected, hot, context.Drawing);
        (_ghost, _steps, BasePoint) = (new SelectionGhost(_drawing, selected), new UndoGroup(context), hot[0].Place);
    }

    /// <summary>Base point of the drag, drawing units: the grip, unless the operator chose another point.</summary>
    public Point2D BasePoint { get; set; }

    /// <summary>True to edit copies and keep the objects.</summary>
    public bool IsCopying { get; set; }

    /// <summary>Number of committed edits.</summary>
    public int Count => _steps.Count;

    /// <summary>The edit for a point in a mode.</summary>
    public Edit CreateEdit(string mode, Point2D place)
    {
        var way = place - BasePoint;
        return mode switch
        {
            "Stretch" => new Edit(null, _hotGrips[0].Place + way),
            "Move" => new Edit(Transform2D.Move(way), null),
            "Mirror" => new Edit(place == BasePoint ? null : Transform2D.MirrorAt(BasePoint, place), null),
            "Rotate" => CreateEdit(mode, way.Direction.Positive().Degrees),
            _ => CreateEdit(mode, way.Length),
        };
    }

    /// <summary>The edit for a typed angle (degrees) or factor.</summary>
    public Edit CreateEdit(string mode, double amount) =>
        new(mode == "Rotate" ? Transform2D.Rotate(BasePoint, Angle.FromDegrees(amount)) : amount > 0.0 ? Transform2D.ScaleFrom(BasePoint, amount) : null, null);

    public IReadOnlyList<Segment> Ghost(Edit edit)
    {
        if (edit.Map is { } map) return _ghost.Mapped(map);
        return edit.To is { } to ? [.. (GripStretch.Changes(_drawing, _hotGrips, to) ?? []).Take(SelectionGhost.MaxSegments).Select(change => change.Segment)] : [];
    }

    /// <returns>False if it is not possible; the reason was reported and nothing is changed.</returns>
    public bool TryCommit(Edit edit)
    {
        var drawing = _context.Drawing;
        if (edit.Map is { } map) return Commit(IsCopying ? DrawingChange.Copied(_context, DocumentState.Following(_selected, _drawing, drawing), [map], reports: Count == 0) : DrawingChange.Mapped(_context, DocumentState.Following(_selected, _drawing, drawing), map));
        var (source, hot) = IsCopying ? Copied(drawing) : (drawing, _hotGrips);
        if (edit.To is { } to && GripStretch.Changes(source, hot, to) is { } changes) return Commit(ChangedPart.Apply(source, changes));
        _context.WriteMessage(Wording.Get("GripEdit.InvalidResult"), MessageKind.Warning);
        return false;
    }

    public void Undo()
    {
        if (!_steps.Undo()) _context.WriteMessage(Wording.Get("Copy.NothingToUndo"));
    }

    /// <summary>The drawing with copies of the dragged objects, and the grips of the copies.</summary>
    private (Drawing Drawing, IReadOnlyList<Grip> Hot) Copied(Drawing drawing)
    {
        int[] held = [.. _hotGrips.Select(grip => grip.Entity).Distinct()];
        DrawingEdit.TryCopy(drawing, held, Transform2D.Identity, out var copied);
        return (copied, [.. _hotGrips.Select(Moved)]);

        Grip Moved(Grip grip)
        {
            var entity = drawing.Entities.Count + Array.IndexOf(held, grip.Entity);
            return grip with { Entity = entity, Part = grip.Part - drawing.Entities[grip.Entity].FirstPart + copied.Entities[entity].FirstPart };
        }
    }

    private bool Commit(Drawing edited)
    {
        var selected = DocumentState.Following(_selected, _drawing, edited);
        _steps.Commit(_context.Document.Current with { Drawing = edited, Selection = selected, Previous = selected });
        return true;
    }

    /// <summary>Either a transformation of the selection or a new grip position; neither: no change.</summary>
    internal readonly record struct Edit(Transform2D? Map, Point2D? To);
}
