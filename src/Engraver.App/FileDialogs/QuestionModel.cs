using Engraver.App.Binding;
using Engraver.App.Texts;

namespace Engraver.App.FileDialogs;

/// <summary>A question with a few answers, over the window. An answer is clicked, or highlighted by typing its first letters and accepted with Enter; Enter
/// alone accepts the first one, Esc none.</summary>
public sealed class QuestionModel : ObservableObject
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
        Cancel();
        (_asked, _typed, Sentence) = (new TaskCompletionSource<string?>(), "", sentence);
        Answers = [.. answers.Select((name, at) => new QuestionAnswer(name, Text.Get(name), new RelayCommand(() => Choose(name))) { IsHighlighted = at == 0 })];
        var answer = _asked.Task;
        OnPropertyChanged(null);
        return answer;
    }

    public void Cancel() => Choose(null);

    /// <summary>Highlights the answer that starts with all letters typed so far, otherwise with the new ones; letters that match no answer change
    /// nothing.</summary>
    public void Type(string letters)
    {
        var typed = new[] { _typed + letters.Trim(), letters.Trim() }.FirstOrDefault(word => word.Length > 0 && Answers.Any(answer => answer.StartsWith(word)));
        if (typed is null) return;
        Highlight(Answers.First(answer => answer.StartsWith(typed)));
        _typed = typed;
    }

    /// <summary>Highlights an answer when it gets the focus: Enter accepts it.</summary>
    public void Highlight(QuestionAnswer meant)
    {
        if (meant.IsHighlighted) return;
        _typed = "";
        foreach (var answer in Answers) answer.IsHighlighted = answer == meant;
    }

    /// <summary>Enter.</summary>
    public void Accept() => Choose(Answers.First(answer => answer.IsHighlighted).Name);

    private void Choose(string? name)
    {
        if (_asked is not { } asked) return;
        _asked = null;
        OnPropertyChanged(null);
        asked.SetResult(name);
    }
}

/// <summary>One answer of a question.</summary>
/// <param name="name">Name of its text.</param>
/// <param name="words">The displayed text.</param>
public sealed class QuestionAnswer(string name, string words, RelayCommand choose) : ObservableObject
{
    private bool _isHighlighted;

    public string Name => name;

    public string Label => words;

    public RelayCommand Choose => choose;

    /// <summary>The answer that Enter accepts.</summary>
    public bool IsHighlighted
    {
        get => _isHighlighted;
        set => SetProperty(ref _isHighlighted, value);
    }

    public bool StartsWith(string letters) => words.StartsWith(letters, StringComparison.CurrentCultureIgnoreCase);
}
