using Engraver.Core.Languages;

namespace Engraver.App.FileDialogs;

/// <summary>A place of the dialog: a folder, or a recent file.</summary>
/// <param name="Path">Full path.</param>
public sealed record FilePlace(string Name, string Path, bool IsFile)
{
    public bool IsFolder => !IsFile;

    public string Tip => TextCatalogue.Fact(Path);
}
