using System.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>A command that waits for a value of a type. Answering runs the command on the caller's thread to its next prompt.</summary>
internal sealed class PendingValue<T>(ValuePrompt<T> prompt) : PendingAsk(prompt)
{
    private readonly TaskCompletionSource<Answer<T>> _answer = new();

    public Task<Answer<T>> Answer => _answer.Task;

    public override string? TryAnswer(string typed, Point2D lastPoint)
    {
        if (typed.Length == 0 && Prompt.Default is null && Prompt.EnterEnds) return Take(new Answer<T>.Ended());
        var input = typed.Length == 0 ? Prompt.Default : typed;
        if (input is null) return Wording.Get("PendingValue.InputRequired", Prompt.Text);
        if (Keyword.Find(Prompt.Options, input) is { } option) return Take(new Answer<T>.Chosen(option.Name));
        return prompt.Read(input, lastPoint) switch
        {
            Reading<T>.Value value => prompt.Refusal?.Invoke(value.Of) ?? Take(new Answer<T>.Value(value.Of)),
            Reading<T>.Wrong wrong => wrong.Sentence,
            _ => throw new UnreachableException(),
        };
    }

    public override void Cancel() => _answer.TrySetCanceled();

    private string? Take(Answer<T> answer)
    {
        _answer.TrySetResult(answer);
        return null;
    }
}

/// <summary>A command that waits for an answer.</summary>
internal abstract class PendingAsk(Prompt prompt)
{
    public Prompt Prompt => prompt;

    /// <summary>Passes an input to the waiting command.</summary>
    /// <returns>Null if it was accepted; otherwise which input is expected, and the command continues to wait.</returns>
    public abstract string? TryAnswer(string typed, Point2D lastPoint);

    /// <summary>Esc: the command ends at the prompt.</summary>
    public abstract void Cancel();
}
