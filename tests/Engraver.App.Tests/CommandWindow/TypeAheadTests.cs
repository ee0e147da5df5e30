using Avalonia.Input;
using Engraver.TestKit;

namespace Engraver.App.Tests.CommandWindow;

/// <summary>Input typed while a command runs; the command runs until the test writes the drawing to the pipe that it reads.</summary>
[Collection(DesktopCollection.Name)]
public sealed class TypeAheadTests(DesktopFixture fixture)
{
    [Fact]
    public Task Words_typed_while_a_command_works_are_run_behind_it_in_their_order_and_none_of_them_reaches_the_machine() => fixture.WithOperator(here =>
    {
        using var pipe = new SlowDrawing(here);
        Type(here, "erase", "all", "cncconnect", "");
        Assert.Contains("A command is running; erase starts when it has ended.", here.History);
        Assert.Contains(here.History, line => line.StartsWith("CNCCONNECT acts on the machine", StringComparison.Ordinal));
        Assert.Contains(here.History, line => line.Contains("Enter without input is ignored", StringComparison.Ordinal));
        Assert.DoesNotContain(here.History, line => line.EndsWith(" erase", StringComparison.Ordinal));

        pipe.Give(Paper());
        here.WaitUntilIdle();

        Assert.Equal("ERASE", here.Desk.Prompt.Command);
        Assert.Equal(4, here.Commands.Document.Current.Drawing!.Entities.Count);
        here.Enter("");
        Assert.Equal(0, here.Commands.Document.Current.Drawing!.Entities.Count);
        Assert.False(here.Commands.Machine.Connection.IsSimulation);
    });

    [Theory]
    [InlineData("escape")]
    [InlineData("stop")]
    [InlineData("damaged")]
    public Task Behind_Esc_STOP_or_a_failure_they_are_not_run(string how) => fixture.WithOperator(here =>
    {
        using var pipe = new SlowDrawing(here);
        Type(here, "layer", "list");
        if (how == "escape") here.Hands.Press(Key.Escape);
        if (how == "stop") here.Desk.StopNow();
        pipe.Give(how == "damaged" ? "this is no drawing"u8.ToArray() : Paper());
        here.WaitUntilIdle();

        Assert.Null(here.Desk.Prompt.Command);
        Assert.Equal(2, here.History.Count(line => line.EndsWith("was typed ahead and not run: the command before it failed or was cancelled.", StringComparison.Ordinal)));
    });

    private static byte[] Paper() => File.ReadAllBytes(Path.Combine(RepositoryFolder.Samples, "paper-001.dxf"));

    private static void Type(Operator here, params string[] words)
    {
        foreach (var word in words)
        {
            here.Hands.Type(word);
            here.Hands.Press(Key.Enter);
            here.Step();
        }
    }

    /// <summary>Keeps OPEN running until the test writes its drawing.</summary>
    private sealed class SlowDrawing : IDisposable
    {
        private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory();
        private readonly Task<FileStream> _writer;

        public SlowDrawing(Operator here)
        {
            var path = NamedPipe.Make(Path.Combine(_folder.FullName, "slow.dxf"));
            _writer = NamedPipe.WriterAsync(path);
            here.Enter("open");
            here.Hands.Type(path);
            here.Hands.Press(Key.Enter);
            here.Until(() => _writer.IsCompleted && here.Commands.IsBusy);
        }

        public void Give(ReadOnlySpan<byte> drawing)
        {
            using var end = _writer.GetAwaiter().GetResult();
            end.Write(drawing);
        }

        public void Dispose() => _folder.Delete(recursive: true);
    }
}
