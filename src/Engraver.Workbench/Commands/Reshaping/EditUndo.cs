using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Reshaping;

/// <summary>The edits of a repeating command: each is visible at once, all together are one undo step, and the command's own Undo option reverts them one by
/// one.</summary>
internal sealed class EditUndo(CommandContext context)
{
    private readonly Stack<(DocumentState State, int Depth)> _before = new();
    private int? _depth;

    private int Depth => context.Document.UndoNames.Count();

    /// <summary>Makes an edit.</summary>
    /// <param name="edit">Commits one document step.</param>
    public void Run(Action edit)
    {
        var (state, depth) = (context.Document.Current, Depth);
        edit();
        if (Depth == depth) return;
        _before.Push((state, depth));
        if (_depth == depth) context.Document.JoinLastSteps();
        else _depth = Depth;
    }

    /// <summary>Reverts the last edit; reports if there is none.</summary>
    /// <returns>False if there was none.</returns>
    public bool Undo()
    {
        if (!_before.TryPop(out var before))
        {
            context.WriteMessage(Wording.Get("Offset.NothingToUndo"));
            return false;
        }

        if (before.Depth < Depth && _depth == Depth) Revert();
        else context.Document.Amend(before.State);
        return true;
    }

    private void Revert()
    {
        context.Document.Undo();
        _depth = null;
    }
}
