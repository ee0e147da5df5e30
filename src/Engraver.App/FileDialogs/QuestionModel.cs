using Engraver.App.Binding;
using Engraver.App.Texts;

namespace Engraver.App.FileDialogs;

/// <summary>A question with a few answers, over the window. An answer is clicked, or highlighted by typing its first letters and accepted with Enter; Enter
/// alone accepts the first one, Esc none.</summary>
public sealed class QuestionModel : Observable
{
    private TaskCompletionSource<string?>? _asked;
    private string _typed = "";

    public bool IsOpen => _asked is not null;

    public string Sentence { get; private set; } = "";

    public IReadOnlyList<QuestionAnswer> Answers { get; private set; } = [];

    /// <param name="answers">Names of their texts; Enter alone accepts the first.</param>
    /// <returns>The chosen name; null if the question was cancelled.</returns>
    public Task<string?> AskAsync(string sentence, params IReadOnlyList<string> answers)
    {
        Leave();
        (_asked, _typed, Sentence) = (new TaskCompletionSource<string?>(), "", sentence);
        Answers = [.. answers.Select((name, at) => new QuestionAnswer(name, Text.Get(name), new Act(() => Choose(name))) { IsMeant = at == 0 })];
        var answer = _asked.Task;
        Tell(null);
        return answer;
    }

    public void Leave() => Choose(null);

    /// <summary>Highlights the answer that starts with all letters typed so far, otherwise with the new ones; letters that match no answer change
    /// nothing.</summary>
    public void Type(string letters)
    {
        var typed = new[] { _typed + letters.Trim(), letters.Trim() }.FirstOrDefault(word => word.Length > 0 && Answers.Any(answer => answer.BeginsWith(word)));
        if (typed is null) return;
        Mean(Answers.First(answer => answer.BeginsWith(typed)));
        _typed = typed;
    }

    /// <summary>Highlights an answer when it gets the focus: Enter accepts it.</summary>
    public void Mean(QuestionAnswer meant)
    {
        if (meant.IsMeant) return;
        _typed = "";
        foreach (var answer in Answers) answer.IsMeant = answer == meant;
    }

    /// <summary>Enter.</summary>
    public void Take() => Choose(Answers.First(answer => answer.IsMeant).Name);

    private void Choose(string? name)
    {
        if (_asked is not { } asked) return;
        _asked = null;
        Tell(null);
        asked.SetResult(name);
    }
}

/// <summary>One answer of a question.</summary>
/// <param name="name">Name of its text.</param>
/// <param name="words">The displayed text.</param>
public sealed class QuestionAnswer(string name, string words, Act choose) : Observable
{
    private bool _isMeant;

    public string Name => name;

    public string Words => words;

    public Act Choose => choose;

    /// <summary>The answer that Enter accepts.</summary>
    public bool IsMeant
    {
        get => _isMeant;
        set => Set(ref _isMeant, value);
    }

    public bool BeginsWith(string letters) => words.StartsWith(letters, StringComparison.CurrentCultureIgnoreCase);
}
