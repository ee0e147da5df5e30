using System.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands;

/// <summary>A command that waits for a value of a type. Answering runs the command on the caller's thread to its next prompt.</summary>
internal sealed class PendingValue<T>(ValuePrompt<T> prompt) : PendingPrompt(prompt)
{
    private readonly TaskCompletionSource<Answer<T>> _answer = new();

    public Task<Answer<T>> Answer => _answer.Task;

    public override string? TryAnswer(string typed, Point2D lastPoint)
    {
        if (typed.Length == 0 && Prompt.Default is null && Prompt.EnterEnds) return SetResult(new Answer<T>.EndOfList());
        var input = typed.Length == 0 ? Prompt.Default : typed;
        if (input is null) return Wording.Get("PendingValue.InputRequired", Prompt.Text);
        if (Keyword.Find(Prompt.Options, input) is { } option) return SetResult(new Answer<T>.SelectedOption(option.Name));
        return prompt.Parse(input, lastPoint) switch
        {
            ParsedInput<T>.Value value => prompt.Validate?.Invoke(value.Result) ?? SetResult(new Answer<T>.Value(value.Result)),
            ParsedInput<T>.Invalid wrong => wrong.Message,
            _ => throw new UnreachableException(),
        };
    }

    public override void Cancel() => _answer.TrySetCanceled();

    private string? SetResult(Answer<T> answer)
    {
        _answer.TrySetResult(answer);
        return null;
    }
}
