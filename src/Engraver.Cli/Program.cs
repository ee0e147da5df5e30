using Engraver.Cli;

return await EngraverProgram.RunAsync(args, new ConsoleStreams(Console.OpenStandardOutput(), Console.Error)).ConfigureAwait(false);
