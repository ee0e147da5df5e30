using System.Reflection;
using Avalonia.Platform.Storage;

namespace Engraver.App.Tests.Shell;

/// <summary>File dialogs of a person who always chooses the same file, or none; it stands for the file too.</summary>
public class AnsweringDialogs : DispatchProxy
{
    /// <summary>What is chosen; null leaves the dialog.</summary>
    public string? Chosen { get; set; }

    /// <summary>What the last dialog was asked for.</summary>
    public PickerOptions? Asked { get; private set; }

    public static (IStorageProvider Dialogs, AnsweringDialogs Person) Make()
    {
        var dialogs = Create<IStorageProvider, AnsweringDialogs>();
        return (dialogs, (AnsweringDialogs)(object)dialogs);
    }

    protected override object? Invoke(MethodInfo? targetMethod, object?[]? args)
    {
        Asked = args?.OfType<PickerOptions>().FirstOrDefault() ?? Asked;
        return targetMethod?.Name switch
        {
            "get_CanOpen" or "get_CanSave" => true,
            "get_Path" => new Uri(Chosen!),
            "OpenFilePickerAsync" => Task.FromResult<IReadOnlyList<IStorageFile>>(Chosen is null ? [] : [File()]),
            "SaveFilePickerAsync" => Task.FromResult(Chosen is null ? null : File()),
            _ => throw new NotSupportedException(targetMethod?.Name),
        };
    }

    private IStorageFile File()
    {
        var file = Create<IStorageFile, AnsweringDialogs>();
        ((AnsweringDialogs)(object)file).Chosen = Chosen;
        return file;
    }
}
