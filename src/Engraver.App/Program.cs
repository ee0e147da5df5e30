using Engraver.App.Sessions;
using Engraver.App.Start;

namespace Engraver.App;

internal static class Program
{
    private const int Usage = 2;

    [STAThread]
    public static int Main(string[] args)
    {
        var (options, wrong) = DesktopOptions.Parse(args);
        if (options is not null) return DesktopProgram.Run(options, Console.Error);
        Console.Error.WriteLine($"engraver-desktop: {wrong}");
        return Usage;
    }
}
