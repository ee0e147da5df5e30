using Avalonia.Threading;
using Engraver.App.Binding;
using Engraver.App.Desk;
using Engraver.App.Texts;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands;

namespace Engraver.App.FileDialogs;

/// <summary>Shows the file dialog when a command requests a file and the system variable FILEDIA is not 0, whether the command was clicked or typed;
/// scripts and pasted lines give their own answers. Asks before a file is replaced and before edits are lost, also when the window closes.</summary>
public sealed class FileQuestions : ObservableObject
{
    private readonly DesktopModel _desk;
    private readonly Func<string> _typed;
    private FileRequest? _asked;
    private bool _isRefreshPending;

    /// <param name="typed">Takes the text typed at the command line after the command: it is the start of the file name.</param>
    public FileQuestions(DesktopModel desk, Func<string> typed)
    {
        (_desk, _typed) = (desk, typed);
        Dialog = new FileDialogModel(desk);
        Dialog.Answered += choice => _ = AnswerAsync(choice);
        Dialog.Cancelled += CancelDialog;
        desk.Notifications.Changed += RefreshSoon;
    }

    /// <summary>Raised when the requested operation failed; the command window shows the reason.</summary>
    public event Action? Refused;

    public FileDialogModel Dialog { get; }

    public QuestionModel Question { get; } = new();

    /// <summary>True if the system variable FILEDIA is not 0.</summary>
    public bool UsesDialogs => _desk.Session.Settings.Current.Variables.GetValueOrDefault("FILEDIA", 1.0) != 0.0;

    /// <summary>No background work is pending, and the dialog matches the prompt.</summary>
    internal bool IsIdle => !_isRefreshPending && !Dialog.IsWorking;

    /// <summary>Opens a drawing that was dropped, or chosen from a list, after asking about edits of the open one.</summary>
    public async Task OpenAsync(string path)
    {
        if (!await ConfirmDiscardEditsAsync("Files.Edited", "Files.OpenAnyway")) return;
        Remember(FileRequest.Drawing, path);
        await ReportRefusalAsync(_desk.Queue.RunAsync("OPEN", TypedFileName.Format(path)));
    }

    /// <summary>Asks about edits before the window closes. Replaces a question that is already open.</summary>
    /// <returns>False if the window stays open: the operator chose so, or the edits could not be saved.</returns>
    public Task<bool> ConfirmCloseAsync() => ConfirmDiscardEditsAsync("Files.EditedClose", "Files.DoNotSave");

    /// <summary>Runs a script that was dropped.</summary>
    public Task RunScriptAsync(string path) => ReportRefusalAsync(_desk.Queue.RunAsync("SCRIPT", TypedFileName.Format(path)));

    private async Task ReportRefusalAsync(Task<InputResult> work)
    {
        if (await work is InputResult.Failed or InputResult.NotAccepted) Refused?.Invoke();
    }

    /// <summary>Updates after the current input is done: a prompt that is answered by the next input of a script does not open a dialog.</summary>
    private void RefreshSoon()
    {
        if (_isRefreshPending) return;
        _isRefreshPending = true;
        Dispatcher.UIThread.Post(Refresh, DispatcherPriority.Input);
    }

    private void Refresh()
    {
        _isRefreshPending = false;
        var wanted = _desk.Prompt.FileRequest;
        if (_asked is not null && !ReferenceEquals(wanted, _asked)) CloseDialog();
        if (wanted is null || _asked is not null || !UsesDialogs || _desk.Queue.IsBusy || !_desk.Queue.Idle.IsCompleted) return;
        _asked = wanted;
        Dialog.Open(wanted, Text.Find("Command." + _desk.Prompt.Command) ?? _desk.Prompt.Command!, _typed());
    }

    private void CloseDialog()
    {
        _asked = null;
        Dialog.Close();
        Question.Cancel();
    }

    private void CancelDialog()
    {
        Dialog.Close();
        _ = _desk.Queue.CancelAsync();
    }

    /// <summary>Answers the command. The dialog closes immediately: what is typed from now on goes to the command line.</summary>
    private Task AnswerNowAsync(FileRequest wanted, string? path)
    {
        Dialog.Close();
        return ReportRefusalAsync(_desk.Queue.AnswerFileAsync(wanted, path is null ? null : AsTyped(path)));
    }

    /// <summary>The path as it would be typed: a file in the working folder by its name alone, so that a journal of inputs also runs in another
    /// folder.</summary>
    private string AsTyped(string path)
    {
        var name = Path.GetRelativePath(_desk.Session.Folder, path);
        return Path.IsPathRooted(name) || name.StartsWith("..", StringComparison.Ordinal) ? path : name;
    }

    /// <param name="choice">Null: the result is shown in the command window.</param>
    private async Task AnswerAsync(FileChoice? choice)
    {
        if (_asked is not { } wanted) return;
        if (choice is null)
        {
            await AnswerNowAsync(wanted, null);
            return;
        }

        if (wanted.Writes && choice.Exists && !await ConfirmReplaceAsync(choice.Path)) return;
        if (wanted is { Kind: FileRequest.Drawing, Writes: false })
        {
            if (await AskAboutEditsAsync("Files.Edited", "Files.OpenAnyway") is not { } saves || !ReferenceEquals(_asked, wanted)) return;
            Remember(wanted.Kind, choice.Path);
            if (saves) await SaveAndOpenAsync(choice.Path);
            else await AnswerNowAsync(wanted, choice.Path);
            return;
        }

        if (!ReferenceEquals(_asked, wanted)) return;
        Remember(wanted.Kind, choice.Path);
        await AnswerNowAsync(wanted, choice.Path);
    }

    /// <summary>The dialog starts in the folder that was used last.</summary>
    private void Remember(string kind, string path) => _desk.Session.Settings.Change(settings => settings.WithFileFolder(kind, Path.GetDirectoryName(Path.GetFullPath(path))!));

    private async Task<bool> ConfirmReplaceAsync(string path) =>
        await Question.AskAsync(Text.Get("Files.Replace", Path.GetFileName(path), Path.GetDirectoryName(path)), "Files.No", "Files.Yes") == "Files.Yes";

    private async Task SaveAndOpenAsync(string path)
    {
        Dialog.Close();
        if (await SaveAsync()) await ReportRefusalAsync(_desk.Queue.RunAsync("OPEN", TypedFileName.Format(path)));
        else Refused?.Invoke();
    }

    /// <returns>False if it could not be saved; also for a new drawing, for which the dialog opens now: the operator has to repeat the operation that
    /// follows.</returns>
    private async Task<bool> SaveAsync() => (_desk.Session.Document.HasFile ? await _desk.Queue.RunAsync("QSAVE", "Yes") : await _desk.Queue.RunAsync("QSAVE")) is InputResult.Done;

    /// <returns>False if the operator keeps the drawing open, or if it could not be saved.</returns>
    private async Task<bool> ConfirmDiscardEditsAsync(string question, string without)
    {
        if (await AskAboutEditsAsync(question, without) is not { } saves) return false;
        if (!saves || await SaveAsync()) return true;
        Refused?.Invoke();
        return false;
    }

    /// <summary>Asks whether unsaved edits are saved first.</summary>
    /// <param name="question">Name of the text, which names the operation that would lose them.</param>
    /// <param name="without">Name of the answer that does not save.</param>
    /// <returns>True: save them; false: there are none, or they may be discarded; null: the drawing stays open.</returns>
    private async Task<bool?> AskAboutEditsAsync(string question, string without)
    {
        if (!_desk.Session.Document.IsEdited) return false;
        var answer = await Question.AskAsync(Text.Get(question, Path.GetFileName(_desk.Session.Document.FilePath)), "Files.SaveFirst", without, "Files.CancelQuestion");
        return answer is null or "Files.CancelQuestion" ? null : answer == "Files.SaveFirst";
    }
}
