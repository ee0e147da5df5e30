using System.Text.Json;
using Engraver.Core.Languages;

namespace Engraver.Core.Tests.Languages;

/// <summary>Errors of the operating system are reported in texts of this program.</summary>
public sealed class SystemErrorTextTests
{
    [Fact]
    public void Files_that_cannot_be_used_say_why_without_the_words_of_the_runtime()
    {
        var folder = Directory.CreateTempSubdirectory("engraver-reason-").FullName;
        try
        {
            Assert.Equal("the file does not exist", Of(() => File.ReadAllText(Path.Combine(folder, "none"))));
            Assert.Equal("the folder does not exist", Of(() => File.ReadAllText(Path.Combine(folder, "none", "none"))));
            Assert.Equal("access is denied", Of(() => File.ReadAllText(folder)));
            Assert.Equal("the path is too long", Of(() => File.ReadAllText(Path.Combine(folder, new string('a', 5000)))));
            using var taken = File.Open(Path.Combine(folder, "taken"), FileMode.Create, FileAccess.Write, FileShare.None);
            Assert.Equal("another program uses it", Of(() => File.Open(Path.Combine(folder, "taken"), FileMode.Open, FileAccess.Write, FileShare.None).Dispose()));
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    [Fact]
    public void A_path_that_the_runtime_names_stands_before_the_reason()
    {
        var missing = Path.Combine(Path.GetTempPath(), "engraver-nowhere", "part.dxf");

        Assert.Equal($"{missing}: the folder does not exist", SystemErrorText.WithPath(Assert.ThrowsAny<IOException>(() => File.ReadAllText(missing))));
    }

    [Fact]
    public void Own_messages_stay_and_damaged_JSON_names_its_line()
    {
        Assert.Equal("The folder is a pipe", SystemErrorText.FromException(new IOException("The folder is a pipe.")));
        Assert.Equal("line 2 is not valid JSON", Of(() => JsonDocument.Parse("{\n \"a\": }")));
    }

    private static string Of(Action refused) => SystemErrorText.FromException(Assert.ThrowsAny<Exception>(refused));
}
