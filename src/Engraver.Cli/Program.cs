using Engraver.Cli;

UnhandledExceptionHandler.Install(args);
var streams = new ConsoleStreams(Console.OpenStandardOutput(), Console.Error, new StreamReader(Console.OpenStandardInput()))
{
    Interactive = !Console.IsInputRedirected && !Console.IsOutputRedirected,
    Keys = Console.IsInputRedirected ? null : () => Console.KeyAvailable ? Console.ReadKey(intercept: true) : null,
};
return await EngraverProgram.RunAsync(args, streams).ConfigureAwait(false);
