using Engraver.App.Binding;
using Engraver.App.Texts;

namespace Engraver.App.FileDialogs;

/// <summary>A question with a few answers, over the window. An answer is clicked, or its first letters are typed and Enter taken; Enter alone takes the first one, Esc none.</summary>
public sealed class QuestionModel : Observable
{
    private TaskCompletionSource<string?>? _asked;
    private string _typed = "";

    public bool IsOpen => _asked is not null;

    /// <summary>Letters of an answer are being typed.</summary>
    internal bool IsTyping => _typed.Length > 0;

    public string Sentence { get; private set; } = "";

    public IReadOnlyList<QuestionAnswer> Answers { get; private set; } = [];

    /// <param name="answers">Names of their texts; the first one is what Enter alone takes.</param>
    /// <returns>The name that was chosen; null when the question was left.</returns>
    public Task<string?> AskAsync(string sentence, params IReadOnlyList<string> answers)
    {
        Leave();
        (_asked, _typed, Sentence) = (new TaskCompletionSource<string?>(), "", sentence);
        Answers = [.. answers.Select((name, at) => new QuestionAnswer(name, Text.Get(name), at == 0, new Act(() => Choose(name))))];
        var answer = _asked.Task;
        Tell(null);
        return answer;
    }

    public void Leave() => Choose(null);

    public void Type(string letters) => _typed += letters.Trim();

    /// <summary>Enter.</summary>
    public void Take()
    {
        var meant = Answers.FirstOrDefault(answer => answer.Words.StartsWith(_typed, StringComparison.CurrentCultureIgnoreCase));
        _typed = "";
        if (meant is not null) Choose(meant.Name);
    }

    private void Choose(string? name)
    {
        if (_asked is not { } asked) return;
        _asked = null;
        Tell(null);
        asked.SetResult(name);
    }
}

/// <summary>One answer of a question.</summary>
/// <param name="IsFirst">What Enter alone takes.</param>
public sealed record QuestionAnswer(string Name, string Words, bool IsFirst, Act Choose);
