using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>Partial edits of a command that are shown at once and form one undo step. Within the command they are undone one by one.</summary>
internal sealed class UndoGroup(CommandContext context)
{
    private readonly Stack<DocumentState> _before = new();

    /// <summary>Number of partial edits.</summary>
    public int Count => _before.Count;

    public void Commit(DocumentState next)
    {
        var before = context.Document.Current;
        if (Count == 0) context.Commit(next);
        else context.Amend(next);
        _before.Push(before);
    }

    /// <returns>False if there is nothing to undo.</returns>
    public bool Undo()
    {
        if (!_before.TryPop(out var before)) return false;
        if (Count == 0) context.Document.Undo();
        else context.Amend(before);
        return true;
    }
}
