using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Drafting;

/// <summary>What a command draws piece by piece. Each piece is in the drawing at once, so that it is seen and can be snapped to; all of them are one
/// step of undo, and Esc keeps what is drawn, as in AutoCAD.</summary>
internal sealed class PiecewiseDrawing
{
    private readonly CommandContext _context;
    private readonly DocumentState _before;
    private bool _isTaken;

    public PiecewiseDrawing(CommandContext context) => (_context, _before) = (context, context.Document.Current);

    /// <summary>Shows these curves instead of those shown before; none takes the step back.</summary>
    /// <exception cref="CommandException">A coordinate is out of the range of a drawing.</exception>
    public void Show(IReadOnlyList<NewCurve> curves)
    {
        if (curves.Count == 0)
        {
            if (_isTaken) _context.Document.Undo();
            _isTaken = false;
            return;
        }

        var next = DrawingAddition.Add(_before, curves);
        if (_isTaken) _context.Document.Amend(next);
        else _context.Take(next);
        _isTaken = true;
    }
}
