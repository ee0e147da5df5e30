using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>Curves that a command draws piece by piece. Each piece is added at once, so that it is visible and can be snapped to. All pieces are one undo step,
/// and Esc keeps them, as in AutoCAD.</summary>
internal sealed class PiecewiseDrawing
{
    private readonly CommandContext _context;
    private readonly DocumentState _before;
    private bool _isCommitted;

    public PiecewiseDrawing(CommandContext context) => (_context, _before) = (context, context.Document.Current);

    /// <summary>Replaces the curves drawn so far; an empty list reverts the step.</summary>
    /// <exception cref="CommandException">A coordinate is out of the range of a drawing.</exception>
    public void Show(IReadOnlyList<NewCurve> curves)
    {
        if (curves.Count == 0)
        {
            if (_isCommitted) _context.Document.Undo();
            _isCommitted = false;
            return;
        }

        var next = DrawingAddition.Add(_before, curves);
        if (_isCommitted) _context.Document.Amend(next);
        else _context.Commit(next);
        _isCommitted = true;
    }
}
