namespace Engraver.App.Canvas.Scenes;

/// <summary>A row of numbers cut into as many equal ranges as there are cores.</summary>
internal static class CoreRanges
{
    public static (int From, int To)[] Of(int count)
    {
        var cores = Math.Max(1, Environment.ProcessorCount);
        var ranges = new (int From, int To)[cores];
        for (var core = 0; core < cores; core++) ranges[core] = ((int)((long)count * core / cores), (int)((long)count * (core + 1) / cores));
        return ranges;
    }
}
