using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>What a command does bit by bit and shows at once, as one step of undo. Inside the command it is taken back bit by bit.</summary>
internal sealed class JoinedSteps(CommandContext context)
{
    private readonly Stack<DocumentState> _before = new();

    /// <summary>How many bits there are now.</summary>
    public int Count => _before.Count;

    public void Take(DocumentState next)
    {
        var before = context.Document.Current;
        if (Count == 0) context.Take(next);
        else context.Amend(next);
        _before.Push(before);
    }

    /// <returns>False when there is nothing to take back.</returns>
    public bool Undo()
    {
        if (!_before.TryPop(out var before)) return false;
        if (Count == 0) context.Document.Undo();
        else context.Amend(before);
        return true;
    }
}
