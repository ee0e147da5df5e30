using System.Globalization;
using System.Text;
using Engraver.Links.Recording;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Tests.Files;

/// <summary>The conversation with a controller is stored compressed, and readable up to its last flush after a crash.</summary>
public sealed class CompressedTextTests : IDisposable
{
    private const double PollSeconds = 0.0116;
    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-text-");

    public void Dispose() => _folder.Delete(recursive: true);

    [Fact]
    public void A_file_that_was_torn_anywhere_behind_its_last_flush_is_read_up_to_it()
    {
        var (path, torn) = (PathOf("whole"), PathOf("torn"));
        var flushed = 0L;
        using (var writer = CompressedText.Create(path))
        {
            for (var line = 0; line < 1000; line++)
            {
                writer.WriteLine(Line(line));
                if (line != 599) continue;
                writer.Flush();
                flushed = new FileInfo(path).Length;
            }
        }

        var bytes = File.ReadAllBytes(path);
        Assert.InRange(flushed, 100, bytes.Length - 100);
        for (var length = flushed; length <= bytes.Length; length += 7)
        {
            File.WriteAllBytes(torn, bytes[..(int)length]);
            using var reader = CompressedText.Open(torn);
            for (var line = 0; line < 600; line++) Assert.Equal(Line(line), reader.ReadLine());
        }

        using var whole = CompressedText.Open(path);
        Assert.Equal(string.Concat(Enumerable.Range(0, 1000).Select(line => Line(line) + "\n")), whole.ReadToEnd());
    }

    [Fact]
    public void A_file_is_read_while_it_is_written()
    {
        using var writer = CompressedText.Create(PathOf("live"));
        writer.WriteLine("first");
        writer.Flush();
        writer.WriteLine("second");

        using var reader = CompressedText.Open(PathOf("live"));
        Assert.Equal(("first", null), (reader.ReadLine(), reader.ReadLine()));
    }

    [Theory]
    [InlineData("#wire;1;controller\n5 0 +\n")]
    [InlineData("a")]
    [InlineData("")]
    public void A_plain_text_of_an_earlier_version_is_read_as_it_is(string text)
    {
        File.WriteAllText(PathOf("plain"), text);

        using var reader = CompressedText.Open(PathOf("plain"));
        Assert.Equal(text, reader.ReadToEnd());
    }

    /// <summary>Regression: 31 MB. Flushed every second, as a run is in real time.</summary>
    [Fact]
    public void An_hour_of_polls_and_segments_takes_less_than_4_MB()
    {
        var path = PathOf("hour");
        using (var writer = CompressedText.Create(path))
        {
            for (var (poll, flushed) = (0, 0.0); poll * PollSeconds < 3600.0; poll++)
            {
                writer.WriteLine(Line(poll));
                if (poll % 8 == 0) writer.WriteLine(new ConversationStep((long)(poll * 116_000L) + 16_000, 0, ConversationEvent.Said, Encoding.ASCII.GetBytes(string.Create(CultureInfo.InvariantCulture, $"VP {poll * 7919 % 100_000},{poll * 104_729 % 100_000}<20000>20000\r"))).ToString());
                if ((poll * PollSeconds) - flushed < 1.0) continue;
                writer.Flush();
                flushed = poll * PollSeconds;
            }
        }

        Assert.InRange(new FileInfo(path).Length, 100_000, 4_000_000);
    }

    private static string Line(int poll) =>
        new ConversationStep(poll * 116_000L, 0, ConversationEvent.Said, "MG _BGS,_BGA,_BGB,_CSS,seq,_VMS,_RPA,_RPB,TIME,_SCA,_XQ0,_XQ1,errcode,wtrip,_OP0\r"u8.ToArray()).ToString();

    private string PathOf(string name) => Path.Combine(_folder.FullName, name);
}
